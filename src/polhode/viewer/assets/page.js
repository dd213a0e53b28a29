/* three.js: The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

The rest is part of polhode, under the MIT licence. */
(()=>{var ny=Object.defineProperty;var as=(i,t)=>{for(var e in t)ny(i,e,{get:t[e],enumerable:!0})};var Ya=class{constructor(t,e){this.seen=t,window.addEventListener("hashchange",()=>{window.location.hash.slice(1)!==this.fragment&&e(this.tables)})}get tables(){return sy(window.location.hash)??{}}get fragment(){return iy(this.seen())}get whole(){let{protocol:t,href:e}=window.location;if(t==="about:")return null;let n=this.fragment;return e.split("#")[0]+(n?`#${n}`:"")}changed(){clearTimeout(this.waiting),this.waiting=setTimeout(()=>this.write(),300)}write(){clearTimeout(this.waiting);let{whole:t}=this;if(!(t===null||t===window.location.href))try{window.history.replaceState(null,"",t)}catch{}}};function iy(i){let t=[];for(let[e,n]of Object.entries(i))if(typeof n!="object")t.push(`${e}=${np(n)}`);else for(let[s,r]of Object.entries(n))t.push(`${e}.${s}=${np(r)}`);return t.join("&")}var np=i=>[i].flat().map(t=>typeof t=="number"?String(t):encodeURIComponent(t)).join(",");function sy(i){let t={};for(let e of i.replace(/^#/,"").split("&").filter(Boolean)){let[n,...s]=e.split("="),r;try{r=decodeURIComponent(s.join("="))}catch{continue}let[o,a]=n.split("."),c=r.includes(",")?r.split(",").map(Number):r!==""&&Number.isFinite(Number(r))?Number(r):r;[c].flat().some(l=>typeof l=="number"&&!Number.isFinite(l))||(a===void 0?t[o]=c:(t[o]??={})[a]=c)}return Object.keys(t).length?t:null}var Bp=0,zu=1,zp=2;var ra=1,kp=2,kr=3,vs=0,xn=1,Si=2,js=0,Gr=1,ku=2,Gu=3,Vu=4,Gp=5;var Qs=100,Vp=101,Hp=102,Wp=103,qp=104,Xp=200,$p=201,Yp=202,Zp=203,Hu=204,Wu=205,Jp=206,Kp=207,jp=208,Qp=209,tm=210,em=211,nm=212,im=213,sm=214,Ec=0,Tc=1,Rc=2,Rr=3,Cc=4,Ic=5,Pc=6,Lc=7,oa=0,rm=1,om=2,bi=0,qu=1,Xu=2,$u=3,Yu=4,Zu=5,Ju=6,Ku=7;var ju=300,tr=301,Vr=302,sl=303,rl=304,Nc=1e3,yi=1001,Dc=1002,$e=1003,am=1004;var aa=1005;var Be=1006,ol=1007;var qi=1008;var An=1009,Qu=1010,td=1011,Hr=1012,al=1013,ai=1014,Zn=1015,ci=1016,cl=1017,ll=1018,er=1020,ed=35902,nd=35899,id=1021,sd=1022,li=1023,Vi=1026,Xi=1027,hl=1028,ul=1029,Ms=1030,dl=1031;var fl=1033,ca=33776,la=33777,ha=33778,ua=33779,pl=35840,ml=35841,gl=35842,xl=35843,_l=36196,yl=37492,vl=37496,Ml=37488,Sl=37489,da=37490,bl=37491,wl=37808,Al=37809,El=37810,Tl=37811,Rl=37812,Cl=37813,Il=37814,Pl=37815,Ll=37816,Nl=37817,Dl=37818,Ul=37819,Ol=37820,Fl=37821,Bl=36492,zl=36494,kl=36495,Gl=36283,Vl=36284,fa=36285,Hl=36286;var Io=2300,Uc=2301,wc=2302,Pu=2303,Lu=2400,Nu=2401,Du=2402;var cm=3200;var Wr=0,lm=1,$i="",Ln="srgb",Po="srgb-linear",Lo="linear",oe="srgb";var Ac=7680;var hm=519,um=512,dm=513,fm=514,rd=515,pm=516,mm=517,od=518,ad=519,cd=35044;var ld="300 es",qn=2e3,Cr=2001;function ry(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function oy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function No(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function gm(){let i=No("canvas");return i.style.display="block",i}var ip={},Ir=null;function Do(...i){let t="THREE."+i.shift();Ir?Ir("log",t,...i):console.log(t,...i)}function xm(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Pt(...i){i=xm(i);let t="THREE."+i.shift();if(Ir)Ir("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Ut(...i){i=xm(i);let t="THREE."+i.shift();if(Ir)Ir("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Ro(...i){let t=i.join(" ");t in ip||(ip[t]=!0,Pt(...i))}function _m(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var ym={[Ec]:Ec,[Rc]:Pc,[Cc]:Cc,[Rr]:Ic,[Tc]:Tc,[Pc]:Rc,[Lc]:Lc,[Ic]:Rr},vi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},an=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],sp=1234567,Er=Math.PI/180,Pr=180/Math.PI;function Ss(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(an[i&255]+an[i>>8&255]+an[i>>16&255]+an[i>>24&255]+"-"+an[t&255]+an[t>>8&255]+"-"+an[t>>16&15|64]+an[t>>24&255]+"-"+an[e&63|128]+an[e>>8&255]+"-"+an[e>>16&255]+an[e>>24&255]+an[n&255]+an[n>>8&255]+an[n>>16&255]+an[n>>24&255]).toLowerCase()}function Ht(i,t,e){return Math.max(t,Math.min(e,i))}function hd(i,t){return(i%t+t)%t}function ay(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function cy(i,t,e){return i!==t?(e-i)/(t-i):0}function Co(i,t,e){return(1-e)*i+e*t}function ly(i,t,e,n){return Co(i,t,1-Math.exp(-e*n))}function hy(i,t=1){return t-Math.abs(hd(i,t*2)-t)}function uy(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function dy(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function fy(i,t){return i+Math.floor(Math.random()*(t-i+1))}function py(i,t){return i+Math.random()*(t-i)}function my(i){return i*(.5-Math.random())}function gy(i){i!==void 0&&(sp=i);let t=sp+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function xy(i){return i*Er}function _y(i){return i*Pr}function yy(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function vy(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function ud(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function My(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,c*u,c*d,a*l);break;case"YZY":i.set(c*d,a*h,c*u,a*l);break;case"ZXZ":i.set(c*u,c*d,a*h,a*l);break;case"XZX":i.set(a*h,c*p,c*f,a*l);break;case"YXY":i.set(c*f,a*h,c*p,a*l);break;case"ZYZ":i.set(c*p,c*f,a*h,a*l);break;default:Pt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Wl(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function dd(i,t){if(t.constructor===Float32Array)return i;let e=Wl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function fd(i,t){if(t.constructor===Float32Array)return i;let e=Wl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var ql={DEG2RAD:Er,RAD2DEG:Pr,generateUUID:Ss,clamp:Ht,euclideanModulo:hd,mapLinear:ay,inverseLerp:cy,lerp:Co,damp:ly,pingpong:hy,smoothstep:uy,smootherstep:dy,randInt:fy,randFloat:py,randFloatSpread:my,seededRandom:gy,degToRad:xy,radToDeg:_y,isPowerOfTwo:yy,ceilPowerOfTwo:vy,floorPowerOfTwo:ud,setQuaternionFromProperEuler:My,normalize:fd,denormalize:dd},Gt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Ht(this.x,t.x,e.x),this.y=Ht(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Ht(this.x,t,e),this.y=Ht(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ht(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Ht(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ae=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let c=n[s+0],l=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],g=r[o+3];if(u!==g||c!==d||l!==f||h!==p){let m=c*d+l*f+h*p+u*g;m<0&&(d=-d,f=-f,p=-p,g=-g,m=-m);let x=1-a;if(m<.9995){let _=Math.acos(m),M=Math.sin(_);x=Math.sin(x*_)/M,a=Math.sin(a*_)/M,c=c*x+d*a,l=l*x+f*a,h=h*x+p*a,u=u*x+g*a}else{c=c*x+d*a,l=l*x+f*a,h=h*x+p*a,u=u*x+g*a;let _=1/Math.sqrt(c*c+l*l+h*h+u*u);c*=_,l*=_,h*=_,u*=_}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+c*f-l*d,t[e+1]=c*p+h*d+l*u-a*f,t[e+2]=l*p+h*f+a*d-c*u,t[e+3]=h*p-a*u-c*d-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(n/2),h=a(s/2),u=a(r/2),d=c(n/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=d*h*u+l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u+d*f*p;break;case"YZX":this._x=d*h*u+l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u-d*f*p;break;case"XZY":this._x=d*h*u-l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u+d*f*p;break;default:Pt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Ht(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-n*l,this._z=r*h+o*l+n*c-s*a,this._w=o*h-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},C=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(rp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(rp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+c*l+o*u-a*h,this.y=n+c*h+a*l-r*u,this.z=s+c*u+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Ht(this.x,t.x,e.x),this.y=Ht(this.y,t.y,e.y),this.z=Ht(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Ht(this.x,t,e),this.y=Ht(this.y,t,e),this.z=Ht(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ht(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return cu.copy(this).projectOnVector(t),this.sub(cu)}reflect(t){return this.sub(cu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Ht(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},cu=new C,rp=new ae,Ft=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l)}set(t,e,n,s,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=c,h[6]=n,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],g=s[0],m=s[3],x=s[6],_=s[1],M=s[4],v=s[7],b=s[2],w=s[5],y=s[8];return r[0]=o*g+a*_+c*b,r[3]=o*m+a*M+c*w,r[6]=o*x+a*v+c*y,r[1]=l*g+h*_+u*b,r[4]=l*m+h*M+u*w,r[7]=l*x+h*v+u*y,r[2]=d*g+f*_+p*b,r[5]=d*m+f*M+p*w,r[8]=d*x+f*v+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-n*r*h+n*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=h*o-a*l,d=a*c-h*r,f=l*r-o*c,p=e*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let g=1/p;return t[0]=u*g,t[1]=(s*l-h*n)*g,t[2]=(a*n-s*o)*g,t[3]=d*g,t[4]=(h*e-s*c)*g,t[5]=(s*r-a*e)*g,t[6]=f*g,t[7]=(n*c-l*e)*g,t[8]=(o*e-n*r)*g,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return Ro("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(lu.makeScale(t,e)),this}rotate(t){return Ro("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(lu.makeRotation(-t)),this}translate(t,e){return Ro("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(lu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},lu=new Ft,op=new Ft().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ap=new Ft().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Sy(){let i={enabled:!0,workingColorSpace:Po,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===oe&&(s.r=Gi(s.r),s.g=Gi(s.g),s.b=Gi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===oe&&(s.r=Tr(s.r),s.g=Tr(s.g),s.b=Tr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===$i?Lo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Po]:{primaries:t,whitePoint:n,transfer:Lo,toXYZ:op,fromXYZ:ap,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ln},outputColorSpaceConfig:{drawingBufferColorSpace:Ln}},[Ln]:{primaries:t,whitePoint:n,transfer:oe,toXYZ:op,fromXYZ:ap,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ln}}}),i}var jt=Sy();function Gi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Tr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var hr,Oc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{hr===void 0&&(hr=No("canvas")),hr.width=t.width,hr.height=t.height;let s=hr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=hr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=No("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Gi(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Gi(e[n]/255)*255):e[n]=Gi(e[n]);return{data:e,width:t.width,height:t.height}}else return Pt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},by=0,Lr=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:by++}),this.uuid=Ss(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(hu(s[o].image)):r.push(hu(s[o]))}else r=hu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function hu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Oc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Pt("Texture: Unable to serialize Texture."),{})}var wy=0,uu=new C,bn=class i extends vi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=yi,s=yi,r=Be,o=qi,a=li,c=An,l=i.DEFAULT_ANISOTROPY,h=$i){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:wy++}),this.uuid=Ss(),this.name="",this.source=new Lr(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Gt(0,0),this.repeat=new Gt(1,1),this.center=new Gt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ft,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(uu).x}get height(){return this.source.getSize(uu).y}get depth(){return this.source.getSize(uu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Pt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Pt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==ju)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Nc:t.x=t.x-Math.floor(t.x);break;case yi:t.x=t.x<0?0:1;break;case Dc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Nc:t.y=t.y-Math.floor(t.y);break;case yi:t.y=t.y<0?0:1;break;case Dc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};bn.DEFAULT_IMAGE=null;bn.DEFAULT_MAPPING=ju;bn.DEFAULT_ANISOTROPY=1;var ce=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],h=c[4],u=c[8],d=c[1],f=c[5],p=c[9],g=c[2],m=c[6],x=c[10];if(Math.abs(h-d)<.01&&Math.abs(u-g)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+g)<.1&&Math.abs(p+m)<.1&&Math.abs(l+f+x-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(l+1)/2,v=(f+1)/2,b=(x+1)/2,w=(h+d)/4,y=(u+g)/4,S=(p+m)/4;return M>v&&M>b?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=w/n,r=y/n):v>b?v<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),n=w/s,r=S/s):b<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(b),n=y/r,s=S/r),this.set(n,s,r,e),this}let _=Math.sqrt((m-p)*(m-p)+(u-g)*(u-g)+(d-h)*(d-h));return Math.abs(_)<.001&&(_=1),this.x=(m-p)/_,this.y=(u-g)/_,this.z=(d-h)/_,this.w=Math.acos((l+f+x-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Ht(this.x,t.x,e.x),this.y=Ht(this.y,t.y,e.y),this.z=Ht(this.z,t.z,e.z),this.w=Ht(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Ht(this.x,t,e),this.y=Ht(this.y,t,e),this.z=Ht(this.z,t,e),this.w=Ht(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ht(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Fc=class extends vi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Be,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new ce(0,0,t,e),this.scissorTest=!1,this.viewport=new ce(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new bn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Be,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Lr(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Nn=class extends Fc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},Uo=class extends bn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=$e,this.minFilter=$e,this.wrapR=yi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Bc=class extends bn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=$e,this.minFilter=$e,this.wrapR=yi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Qt=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,c,l,h,u,d,f,p,g,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l,h,u,d,f,p,g,m)}set(t,e,n,s,r,o,a,c,l,h,u,d,f,p,g,m){let x=this.elements;return x[0]=t,x[4]=e,x[8]=n,x[12]=s,x[1]=r,x[5]=o,x[9]=a,x[13]=c,x[2]=l,x[6]=h,x[10]=u,x[14]=d,x[3]=f,x[7]=p,x[11]=g,x[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/ur.setFromMatrixColumn(t,0).length(),r=1/ur.setFromMatrixColumn(t,1).length(),o=1/ur.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,g=a*u;e[0]=c*h,e[4]=-c*u,e[8]=l,e[1]=f+p*l,e[5]=d-g*l,e[9]=-a*c,e[2]=g-d*l,e[6]=p+f*l,e[10]=o*c}else if(t.order==="YXZ"){let d=c*h,f=c*u,p=l*h,g=l*u;e[0]=d+g*a,e[4]=p*a-f,e[8]=o*l,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=g+d*a,e[10]=o*c}else if(t.order==="ZXY"){let d=c*h,f=c*u,p=l*h,g=l*u;e[0]=d-g*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=g-d*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,g=a*u;e[0]=c*h,e[4]=p*l-f,e[8]=d*l+g,e[1]=c*u,e[5]=g*l+d,e[9]=f*l-p,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let d=o*c,f=o*l,p=a*c,g=a*l;e[0]=c*h,e[4]=g-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-l*h,e[6]=f*u+p,e[10]=d-g*u}else if(t.order==="XZY"){let d=o*c,f=o*l,p=a*c,g=a*l;e[0]=c*h,e[4]=-u,e[8]=l*h,e[1]=d*u+g,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=g*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Ay,t,Ey)}lookAt(t,e,n){let s=this.elements;return In.subVectors(t,e),In.lengthSq()===0&&(In.z=1),In.normalize(),cs.crossVectors(n,In),cs.lengthSq()===0&&(Math.abs(n.z)===1?In.x+=1e-4:In.z+=1e-4,In.normalize(),cs.crossVectors(n,In)),cs.normalize(),Za.crossVectors(In,cs),s[0]=cs.x,s[4]=Za.x,s[8]=In.x,s[1]=cs.y,s[5]=Za.y,s[9]=In.y,s[2]=cs.z,s[6]=Za.z,s[10]=In.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],g=n[6],m=n[10],x=n[14],_=n[3],M=n[7],v=n[11],b=n[15],w=s[0],y=s[4],S=s[8],I=s[12],T=s[1],L=s[5],N=s[9],F=s[13],P=s[2],B=s[6],G=s[10],H=s[14],j=s[3],W=s[7],Y=s[11],tt=s[15];return r[0]=o*w+a*T+c*P+l*j,r[4]=o*y+a*L+c*B+l*W,r[8]=o*S+a*N+c*G+l*Y,r[12]=o*I+a*F+c*H+l*tt,r[1]=h*w+u*T+d*P+f*j,r[5]=h*y+u*L+d*B+f*W,r[9]=h*S+u*N+d*G+f*Y,r[13]=h*I+u*F+d*H+f*tt,r[2]=p*w+g*T+m*P+x*j,r[6]=p*y+g*L+m*B+x*W,r[10]=p*S+g*N+m*G+x*Y,r[14]=p*I+g*F+m*H+x*tt,r[3]=_*w+M*T+v*P+b*j,r[7]=_*y+M*L+v*B+b*W,r[11]=_*S+M*N+v*G+b*Y,r[15]=_*I+M*F+v*H+b*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],g=t[7],m=t[11],x=t[15],_=c*f-l*d,M=a*f-l*u,v=a*d-c*u,b=o*f-l*h,w=o*d-c*h,y=o*u-a*h;return e*(g*_-m*M+x*v)-n*(p*_-m*b+x*w)+s*(p*M-g*b+x*y)-r*(p*v-g*w+m*y)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],h=t[10];return e*(o*h-a*l)-n*(r*h-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],g=t[13],m=t[14],x=t[15],_=e*a-n*o,M=e*c-s*o,v=e*l-r*o,b=n*c-s*a,w=n*l-r*a,y=s*l-r*c,S=h*g-u*p,I=h*m-d*p,T=h*x-f*p,L=u*m-d*g,N=u*x-f*g,F=d*x-f*m,P=_*F-M*N+v*L+b*T-w*I+y*S;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let B=1/P;return t[0]=(a*F-c*N+l*L)*B,t[1]=(s*N-n*F-r*L)*B,t[2]=(g*y-m*w+x*b)*B,t[3]=(d*w-u*y-f*b)*B,t[4]=(c*T-o*F-l*I)*B,t[5]=(e*F-s*T+r*I)*B,t[6]=(m*v-p*y-x*M)*B,t[7]=(h*y-d*v+f*M)*B,t[8]=(o*N-a*T+l*S)*B,t[9]=(n*T-e*N-r*S)*B,t[10]=(p*w-g*v+x*_)*B,t[11]=(u*v-h*w-f*_)*B,t[12]=(a*I-o*L-c*S)*B,t[13]=(e*L-n*I+s*S)*B,t[14]=(g*M-p*b-m*_)*B,t[15]=(h*b-u*M+d*_)*B,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+n,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,u=a+a,d=r*l,f=r*h,p=r*u,g=o*h,m=o*u,x=a*u,_=c*l,M=c*h,v=c*u,b=n.x,w=n.y,y=n.z;return s[0]=(1-(g+x))*b,s[1]=(f+v)*b,s[2]=(p-M)*b,s[3]=0,s[4]=(f-v)*w,s[5]=(1-(d+x))*w,s[6]=(m+_)*w,s[7]=0,s[8]=(p+M)*y,s[9]=(m-_)*y,s[10]=(1-(d+g))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=ur.set(s[0],s[1],s[2]).length(),a=ur.set(s[4],s[5],s[6]).length(),c=ur.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ei.copy(this);let l=1/o,h=1/a,u=1/c;return ei.elements[0]*=l,ei.elements[1]*=l,ei.elements[2]*=l,ei.elements[4]*=h,ei.elements[5]*=h,ei.elements[6]*=h,ei.elements[8]*=u,ei.elements[9]*=u,ei.elements[10]*=u,e.setFromRotationMatrix(ei),n.x=o,n.y=a,n.z=c,this}makePerspective(t,e,n,s,r,o,a=qn,c=!1){let l=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),p,g;if(c)p=r/(o-r),g=o*r/(o-r);else if(a===qn)p=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===Cr)p=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=qn,c=!1){let l=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),p,g;if(c)p=1/(o-r),g=o/(o-r);else if(a===qn)p=-2/(o-r),g=-(o+r)/(o-r);else if(a===Cr)p=-1/(o-r),g=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=u,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},ur=new C,ei=new Qt,Ay=new C(0,0,0),Ey=new C(1,1,1),cs=new C,Za=new C,In=new C,cp=new Qt,lp=new ae,Mi=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Ht(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Ht(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ht(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Ht(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(Ht(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ht(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Pt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return cp.makeRotationFromQuaternion(t),this.setFromRotationMatrix(cp,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return lp.setFromEuler(this),this.setFromQuaternion(lp,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Mi.DEFAULT_ORDER="XYZ";var Oo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Ty=0,hp=new C,dr=new ae,Ui=new Qt,Ja=new C,Mo=new C,Ry=new C,Cy=new ae,up=new C(1,0,0),dp=new C(0,1,0),fp=new C(0,0,1),pp={type:"added"},Iy={type:"removed"},fr={type:"childadded",child:null},du={type:"childremoved",child:null},je=class i extends vi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ty++}),this.uuid=Ss(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new C,e=new Mi,n=new ae,s=new C(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qt},normalMatrix:{value:new Ft}}),this.matrix=new Qt,this.matrixWorld=new Qt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Oo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return dr.setFromAxisAngle(t,e),this.quaternion.multiply(dr),this}rotateOnWorldAxis(t,e){return dr.setFromAxisAngle(t,e),this.quaternion.premultiply(dr),this}rotateX(t){return this.rotateOnAxis(up,t)}rotateY(t){return this.rotateOnAxis(dp,t)}rotateZ(t){return this.rotateOnAxis(fp,t)}translateOnAxis(t,e){return hp.copy(t).applyQuaternion(this.quaternion),this.position.add(hp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(up,t)}translateY(t){return this.translateOnAxis(dp,t)}translateZ(t){return this.translateOnAxis(fp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ui.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Ja.copy(t):Ja.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Mo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ui.lookAt(Mo,Ja,this.up):Ui.lookAt(Ja,Mo,this.up),this.quaternion.setFromRotationMatrix(Ui),s&&(Ui.extractRotation(s.matrixWorld),dr.setFromRotationMatrix(Ui),this.quaternion.premultiply(dr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Ut("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(pp),fr.child=t,this.dispatchEvent(fr),fr.child=null):Ut("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Iy),du.child=t,this.dispatchEvent(du),du.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ui.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ui.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ui),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(pp),fr.child=t,this.dispatchEvent(fr),fr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Mo,t,Ry),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Mo,Cy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let u=c[l];r(t.shapes,u)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};je.DEFAULT_UP=new C(0,1,0);je.DEFAULT_MATRIX_AUTO_UPDATE=!0;je.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var he=class extends je{constructor(){super(),this.isGroup=!0,this.type="Group"}},Py={type:"move"},Nr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new he,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new he,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new C,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new C),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new he,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new C,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new C,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let g of t.hand.values()){let m=e.getJointPose(g,n),x=this._getHandJoint(l,g);m!==null&&(x.matrix.fromArray(m.transform.matrix),x.matrix.decompose(x.position,x.quaternion,x.scale),x.matrixWorldNeedsUpdate=!0,x.jointRadius=m.radius),x.visible=m!==null}let h=l.joints["index-finger-tip"],u=l.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;l.inputState.pinching&&d>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Py)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new he;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},vm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ls={h:0,s:0,l:0},Ka={h:0,s:0,l:0};function fu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Ot=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ln){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,jt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=jt.workingColorSpace){return this.r=t,this.g=e,this.b=n,jt.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=jt.workingColorSpace){if(t=hd(t,1),e=Ht(e,0,1),n=Ht(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=fu(o,r,t+1/3),this.g=fu(o,r,t),this.b=fu(o,r,t-1/3)}return jt.colorSpaceToWorking(this,s),this}setStyle(t,e=Ln){function n(r){r!==void 0&&parseFloat(r)<1&&Pt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Pt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Pt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ln){let n=vm[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Pt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Gi(t.r),this.g=Gi(t.g),this.b=Gi(t.b),this}copyLinearToSRGB(t){return this.r=Tr(t.r),this.g=Tr(t.g),this.b=Tr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ln){return jt.workingToColorSpace(cn.copy(this),t),Math.round(Ht(cn.r*255,0,255))*65536+Math.round(Ht(cn.g*255,0,255))*256+Math.round(Ht(cn.b*255,0,255))}getHexString(t=Ln){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=jt.workingColorSpace){jt.workingToColorSpace(cn.copy(this),e);let n=cn.r,s=cn.g,r=cn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let u=o-a;switch(l=h<=.5?u/(o+a):u/(2-o-a),o){case n:c=(s-r)/u+(s<r?6:0);break;case s:c=(r-n)/u+2;break;case r:c=(n-s)/u+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=jt.workingColorSpace){return jt.workingToColorSpace(cn.copy(this),e),t.r=cn.r,t.g=cn.g,t.b=cn.b,t}getStyle(t=Ln){jt.workingToColorSpace(cn.copy(this),t);let e=cn.r,n=cn.g,s=cn.b;return t!==Ln?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(ls),this.setHSL(ls.h+t,ls.s+e,ls.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(ls),t.getHSL(Ka);let n=Co(ls.h,Ka.h,e),s=Co(ls.s,Ka.s,e),r=Co(ls.l,Ka.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},cn=new Ot;Ot.NAMES=vm;var Fo=class extends je{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Mi,this.environmentIntensity=1,this.environmentRotation=new Mi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},ni=new C,Oi=new C,pu=new C,Fi=new C,pr=new C,mr=new C,mp=new C,mu=new C,gu=new C,xu=new C,_u=new ce,yu=new ce,vu=new ce,ki=class i{constructor(t=new C,e=new C,n=new C){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),ni.subVectors(t,e),s.cross(ni);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){ni.subVectors(s,e),Oi.subVectors(n,e),pu.subVectors(t,e);let o=ni.dot(ni),a=ni.dot(Oi),c=ni.dot(pu),l=Oi.dot(Oi),h=Oi.dot(pu),u=o*l-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(l*c-a*h)*d,p=(o*h-a*c)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Fi)===null?!1:Fi.x>=0&&Fi.y>=0&&Fi.x+Fi.y<=1}static getInterpolation(t,e,n,s,r,o,a,c){return this.getBarycoord(t,e,n,s,Fi)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Fi.x),c.addScaledVector(o,Fi.y),c.addScaledVector(a,Fi.z),c)}static getInterpolatedAttribute(t,e,n,s,r,o){return _u.setScalar(0),yu.setScalar(0),vu.setScalar(0),_u.fromBufferAttribute(t,e),yu.fromBufferAttribute(t,n),vu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(_u,r.x),o.addScaledVector(yu,r.y),o.addScaledVector(vu,r.z),o}static isFrontFacing(t,e,n,s){return ni.subVectors(n,e),Oi.subVectors(t,e),ni.cross(Oi).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return ni.subVectors(this.c,this.b),Oi.subVectors(this.a,this.b),ni.cross(Oi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;pr.subVectors(s,n),mr.subVectors(r,n),mu.subVectors(t,n);let c=pr.dot(mu),l=mr.dot(mu);if(c<=0&&l<=0)return e.copy(n);gu.subVectors(t,s);let h=pr.dot(gu),u=mr.dot(gu);if(h>=0&&u<=h)return e.copy(s);let d=c*u-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),e.copy(n).addScaledVector(pr,o);xu.subVectors(t,r);let f=pr.dot(xu),p=mr.dot(xu);if(p>=0&&f<=p)return e.copy(r);let g=f*l-c*p;if(g<=0&&l>=0&&p<=0)return a=l/(l-p),e.copy(n).addScaledVector(mr,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return mp.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(mp,a);let x=1/(m+g+d);return o=g*x,a=d*x,e.copy(n).addScaledVector(pr,o).addScaledVector(mr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},mn=class{constructor(t=new C(1/0,1/0,1/0),e=new C(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(ii.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(ii.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=ii.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,ii):ii.fromBufferAttribute(r,o),ii.applyMatrix4(t.matrixWorld),this.expandByPoint(ii);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),ja.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),ja.copy(n.boundingBox)),ja.applyMatrix4(t.matrixWorld),this.union(ja)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,ii),ii.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(So),Qa.subVectors(this.max,So),gr.subVectors(t.a,So),xr.subVectors(t.b,So),_r.subVectors(t.c,So),hs.subVectors(xr,gr),us.subVectors(_r,xr),Xs.subVectors(gr,_r);let e=[0,-hs.z,hs.y,0,-us.z,us.y,0,-Xs.z,Xs.y,hs.z,0,-hs.x,us.z,0,-us.x,Xs.z,0,-Xs.x,-hs.y,hs.x,0,-us.y,us.x,0,-Xs.y,Xs.x,0];return!Mu(e,gr,xr,_r,Qa)||(e=[1,0,0,0,1,0,0,0,1],!Mu(e,gr,xr,_r,Qa))?!1:(tc.crossVectors(hs,us),e=[tc.x,tc.y,tc.z],Mu(e,gr,xr,_r,Qa))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,ii).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(ii).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Bi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Bi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Bi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Bi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Bi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Bi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Bi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Bi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Bi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Bi=[new C,new C,new C,new C,new C,new C,new C,new C],ii=new C,ja=new mn,gr=new C,xr=new C,_r=new C,hs=new C,us=new C,Xs=new C,So=new C,Qa=new C,tc=new C,$s=new C;function Mu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){$s.fromArray(i,r);let a=s.x*Math.abs($s.x)+s.y*Math.abs($s.y)+s.z*Math.abs($s.z),c=t.dot($s),l=e.dot($s),h=n.dot($s);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var Oe=new C,ec=new Gt,Ly=0,Ce=class extends vi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ly++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=cd,this.updateRanges=[],this.gpuType=Zn,this.version=0,this._normalizationScale=t!==void 0?Wl(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)ec.fromBufferAttribute(this,e),ec.applyMatrix3(t),this.setXY(e,ec.x,ec.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Oe.fromBufferAttribute(this,e),Oe.applyMatrix3(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Oe.fromBufferAttribute(this,e),Oe.applyMatrix4(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Oe.fromBufferAttribute(this,e),Oe.applyNormalMatrix(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Oe.fromBufferAttribute(this,e),Oe.transformDirection(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):dd(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):fd(t,this.array)}};var Bo=class extends Ce{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var zo=class extends Ce{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var ee=class extends Ce{constructor(t,e,n){super(new Float32Array(t),e,n)}},Ny=new mn,bo=new C,Su=new C,wn=class{constructor(t=new C,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Ny.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;bo.subVectors(t,this.center);let e=bo.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(bo,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Su.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(bo.copy(t.center).add(Su)),this.expandByPoint(bo.copy(t.center).sub(Su))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Dy=0,Wn=new Qt,bu=new je,yr=new C,Pn=new mn,wo=new mn,Xe=new C,_e=class i extends vi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Dy++}),this.uuid=Ss(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(ry(t)?zo:Bo)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Ft().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Wn.makeRotationFromQuaternion(t),this.applyMatrix4(Wn),this}rotateX(t){return Wn.makeRotationX(t),this.applyMatrix4(Wn),this}rotateY(t){return Wn.makeRotationY(t),this.applyMatrix4(Wn),this}rotateZ(t){return Wn.makeRotationZ(t),this.applyMatrix4(Wn),this}translate(t,e,n){return Wn.makeTranslation(t,e,n),this.applyMatrix4(Wn),this}scale(t,e,n){return Wn.makeScale(t,e,n),this.applyMatrix4(Wn),this}lookAt(t){return bu.lookAt(t),bu.updateMatrix(),this.applyMatrix4(bu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(yr).negate(),this.translate(yr.x,yr.y,yr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ee(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Pt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new mn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ut("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new C(-1/0,-1/0,-1/0),new C(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];Pn.setFromBufferAttribute(r),this.morphTargetsRelative?(Xe.addVectors(this.boundingBox.min,Pn.min),this.boundingBox.expandByPoint(Xe),Xe.addVectors(this.boundingBox.max,Pn.max),this.boundingBox.expandByPoint(Xe)):(this.boundingBox.expandByPoint(Pn.min),this.boundingBox.expandByPoint(Pn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ut('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new wn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ut("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new C,1/0);return}if(t){let n=this.boundingSphere.center;if(Pn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];wo.setFromBufferAttribute(a),this.morphTargetsRelative?(Xe.addVectors(Pn.min,wo.min),Pn.expandByPoint(Xe),Xe.addVectors(Pn.max,wo.max),Pn.expandByPoint(Xe)):(Pn.expandByPoint(wo.min),Pn.expandByPoint(wo.max))}Pn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Xe.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Xe));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)Xe.fromBufferAttribute(a,l),c&&(yr.fromBufferAttribute(t,l),Xe.add(yr)),s=Math.max(s,n.distanceToSquared(Xe))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ut('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Ut("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Ce(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let I=0;I<n.count;I++)a[I]=new C,c[I]=new C;let h=new C,u=new C,d=new C,f=new Gt,p=new Gt,g=new Gt,m=new C,x=new C;function _(I,T,L){l[I]=l[T]=l[L]=1,h.fromBufferAttribute(n,I),u.fromBufferAttribute(n,T),d.fromBufferAttribute(n,L),f.fromBufferAttribute(r,I),p.fromBufferAttribute(r,T),g.fromBufferAttribute(r,L),u.sub(h),d.sub(h),p.sub(f),g.sub(f);let N=1/(p.x*g.y-g.x*p.y);isFinite(N)&&(m.copy(u).multiplyScalar(g.y).addScaledVector(d,-p.y).multiplyScalar(N),x.copy(d).multiplyScalar(p.x).addScaledVector(u,-g.x).multiplyScalar(N),a[I].add(m),a[T].add(m),a[L].add(m),c[I].add(x),c[T].add(x),c[L].add(x))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let I=0,T=M.length;I<T;++I){let L=M[I],N=L.start,F=L.count;for(let P=N,B=N+F;P<B;P+=3)_(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let v=new C,b=new C,w=new C,y=new C;function S(I){w.fromBufferAttribute(s,I),y.copy(w);let T=a[I];v.copy(T),v.sub(w.multiplyScalar(w.dot(T))).normalize(),b.crossVectors(y,T);let N=b.dot(c[I])<0?-1:1;o.setXYZW(I,v.x,v.y,v.z,N)}for(let I=0,T=n.count;I<T;++I)l[I]&&S(I);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Ce(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new C,r=new C,o=new C,a=new C,c=new C,l=new C,h=new C,u=new C;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),g=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,g),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),c.fromBufferAttribute(n,g),l.fromBufferAttribute(n,m),a.add(h),c.add(h),l.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(g,c.x,c.y,c.z),n.setXYZ(m,l.x,l.y,l.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Xe.fromBufferAttribute(t,e),Xe.normalize(),t.setXYZ(e,Xe.x,Xe.y,Xe.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,u=a.normalized,d=new l.constructor(c.length*h),f=0,p=0;for(let g=0,m=c.length;g<m;g++){a.isInterleavedBufferAttribute?f=c[g]*a.data.stride+a.offset:f=c[g]*h;for(let x=0;x<h;x++)d[p++]=l[f++]}return new Ce(d,h,u)}if(this.index===null)return Pt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,n);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,u=l.length;h<u;h++){let d=l[h],f=t(d,n);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let u=0,d=l.length;u<d;u++){let f=l[u];h.push(f.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],u=r[l];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let u=o[l];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ko=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=cd,this.updateRanges=[],this.version=0,this.uuid=Ss()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=gp(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=gp(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function gp(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Ss()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var fn=new C,Xn=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?Wl(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix4(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.applyNormalMatrix(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)fn.fromBufferAttribute(this,e),fn.transformDirection(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Do("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Ce(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Do("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):dd(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):fd(t,this.data.array)}},wu=new C,Uy=new C,Oy=new Ft,si=class{constructor(t=new C(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=wu.subVectors(n,e).cross(Uy.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(wu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Oy.getNormalMatrix(t),s=this.coplanarPoint(wu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Fy=0,$n=class extends vi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Fy++}),this.uuid=Ss(),this.name="",this.type="Material",this.blending=Gr,this.side=vs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Hu,this.blendDst=Wu,this.blendEquation=Qs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ot(0,0,0),this.blendAlpha=0,this.depthFunc=Rr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=hm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ac,this.stencilZFail=Ac,this.stencilZPass=Ac,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Pt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Pt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Ot().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new si().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Gt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Gt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var zi=new C,Au=new C,nc=new C,ic=new C,Dr=class{constructor(t=new C,e=new C(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,zi)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=zi.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(zi.copy(this.origin).addScaledVector(this.direction,e),zi.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Au.copy(t).add(e).multiplyScalar(.5),nc.copy(e).sub(t).normalize(),ic.copy(this.origin).sub(Au);let r=t.distanceTo(e)*.5,o=-this.direction.dot(nc),a=ic.dot(this.direction),c=-ic.dot(nc),l=ic.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*c-a,d=o*a-c,p=r*h,u>=0)if(d>=-p)if(d<=p){let g=1/h;u*=g,d*=g,f=u*(u+o*d+2*a)+d*(o*u+d+2*c)+l}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l):d<=p?(u=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Au).addScaledVector(nc,d),f}intersectSphere(t,e){if(t.radius<0)return null;zi.subVectors(t.center,this.origin);let n=zi.dot(this.direction),s=zi.dot(zi)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return l>=0?(n=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(n=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,c=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,c=(t.min.z-d.z)*u),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,zi)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,g=e.y-o.y,m=e.z-o.z,x=n.x-o.x,_=n.y-o.y,M=n.z-o.z,v=Math.abs(c),b=Math.abs(l),w=Math.abs(h),y,S,I,T,L,N,F,P,B,G,H,j;if(v>=b&&v>=w?(I=c,N=u,B=p,j=x,c>=0?(y=l,S=h,T=d,L=f,F=g,P=m,G=_,H=M):(y=h,S=l,T=f,L=d,F=m,P=g,G=M,H=_)):b>=w?(I=l,N=d,B=g,j=_,l>=0?(y=h,S=c,T=f,L=u,F=m,P=p,G=M,H=x):(y=c,S=h,T=u,L=f,F=p,P=m,G=x,H=M)):(I=h,N=f,B=m,j=M,h>=0?(y=c,S=l,T=u,L=d,F=p,P=g,G=x,H=_):(y=l,S=c,T=d,L=u,F=g,P=p,G=_,H=x)),I===0)return null;let W=y/I,Y=S/I,tt=1/I,gt=T-W*N,wt=L-Y*N,X=F-W*B,rt=P-Y*B,xt=G-W*j,At=H-Y*j,pt=xt*rt-At*X,Dt=gt*At-wt*xt,me=X*wt-rt*gt;if(s){if(pt<0||Dt<0||me<0)return null}else if((pt<0||Dt<0||me<0)&&(pt>0||Dt>0||me>0))return null;let Rt=pt+Dt+me;if(Rt===0)return null;let Zt=tt*(pt*N+Dt*B+me*j);return(Rt>0?Zt<0:Zt>0)?null:this.at(Zt/Rt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ln=class extends $n{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ot(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Mi,this.combine=oa,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},xp=new Qt,Ys=new Dr,sc=new wn,_p=new C,rc=new C,oc=new C,ac=new C,Eu=new C,cc=new C,yp=new C,lc=new C,Yt=class extends je{constructor(t=new _e,e=new ln){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){cc.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],u=r[c];h!==0&&(Eu.fromBufferAttribute(u,t),o?cc.addScaledVector(Eu,h):cc.addScaledVector(Eu.sub(e),h))}e.add(cc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),sc.copy(n.boundingSphere),sc.applyMatrix4(r),Ys.copy(t.ray).recast(t.near),!(sc.containsPoint(Ys.origin)===!1&&(Ys.intersectSphere(sc,_p)===null||Ys.origin.distanceToSquared(_p)>(t.far-t.near)**2))&&(xp.copy(r).invert(),Ys.copy(t.ray).applyMatrix4(xp),!(n.boundingBox!==null&&Ys.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Ys)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,g=d.length;p<g;p++){let m=d[p],x=o[m.materialIndex],_=Math.max(m.start,f.start),M=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=_,b=M;v<b;v+=3){let w=a.getX(v),y=a.getX(v+1),S=a.getX(v+2);s=hc(this,x,t,n,l,h,u,w,y,S),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),g=Math.min(a.count,f.start+f.count);for(let m=p,x=g;m<x;m+=3){let _=a.getX(m),M=a.getX(m+1),v=a.getX(m+2);s=hc(this,o,t,n,l,h,u,_,M,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,g=d.length;p<g;p++){let m=d[p],x=o[m.materialIndex],_=Math.max(m.start,f.start),M=Math.min(c.count,Math.min(m.start+m.count,f.start+f.count));for(let v=_,b=M;v<b;v+=3){let w=v,y=v+1,S=v+2;s=hc(this,x,t,n,l,h,u,w,y,S),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),g=Math.min(c.count,f.start+f.count);for(let m=p,x=g;m<x;m+=3){let _=m,M=m+1,v=m+2;s=hc(this,o,t,n,l,h,u,_,M,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function By(i,t,e,n,s,r,o,a){let c;if(t.side===xn?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,t.side===vs,a),c===null)return null;lc.copy(a),lc.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(lc);return l<e.near||l>e.far?null:{distance:l,point:lc.clone(),object:i}}function hc(i,t,e,n,s,r,o,a,c,l){i.getVertexPosition(a,rc),i.getVertexPosition(c,oc),i.getVertexPosition(l,ac);let h=By(i,t,e,n,rc,oc,ac,yp);if(h){let u=new C;ki.getBarycoord(yp,rc,oc,ac,u),s&&(h.uv=ki.getInterpolatedAttribute(s,a,c,l,u,new Gt)),r&&(h.uv1=ki.getInterpolatedAttribute(r,a,c,l,u,new Gt)),o&&(h.normal=ki.getInterpolatedAttribute(o,a,c,l,u,new C),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new C,materialIndex:0};ki.getNormal(rc,oc,ac,d.normal),h.face=d,h.barycoord=u}return h}var ri=class extends bn{constructor(t=null,e=1,n=1,s,r,o,a,c,l=$e,h=$e,u,d){super(null,o,a,c,l,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ur=class extends Ce{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},vr=new Qt,vp=new Qt,uc=[],Mp=new mn,zy=new Qt,Ao=new Yt,Eo=new wn,Go=class extends Yt{constructor(t,e,n){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Ur(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,zy)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new mn),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,vr),Mp.copy(t.boundingBox).applyMatrix4(vr),this.boundingBox.union(Mp)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new wn),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,vr),Eo.copy(t.boundingSphere).applyMatrix4(vr),this.boundingSphere.union(Eo)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(Ao.geometry=this.geometry,Ao.material=this.material,Ao.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Eo.copy(this.boundingSphere),Eo.applyMatrix4(n),t.ray.intersectsSphere(Eo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,vr),vp.multiplyMatrices(n,vr),Ao.matrixWorld=vp,Ao.raycast(t,uc);for(let o=0,a=uc.length;o<a;o++){let c=uc[o];c.instanceId=r,c.object=this,e.push(c)}uc.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Ur(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new ri(new Float32Array(s*this.count),s,this.count,hl,Zn));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<n.length;l++)o+=n[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*t;return r[c]=a,r.set(n,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Zs=new wn,ky=new Gt(.5,.5),dc=new C,fs=class{constructor(t=new si,e=new si,n=new si,s=new si,r=new si,o=new si){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=qn,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],g=r[9],m=r[10],x=r[11],_=r[12],M=r[13],v=r[14],b=r[15];if(s[0].setComponents(l-o,f-h,x-p,b-_).normalize(),s[1].setComponents(l+o,f+h,x+p,b+_).normalize(),s[2].setComponents(l+a,f+u,x+g,b+M).normalize(),s[3].setComponents(l-a,f-u,x-g,b-M).normalize(),n)s[4].setComponents(c,d,m,v).normalize(),s[5].setComponents(l-c,f-d,x-m,b-v).normalize();else if(s[4].setComponents(l-c,f-d,x-m,b-v).normalize(),e===qn)s[5].setComponents(l+c,f+d,x+m,b+v).normalize();else if(e===Cr)s[5].setComponents(c,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Zs.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Zs.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Zs)}intersectsSprite(t){Zs.center.set(0,0,0);let e=ky.distanceTo(t.center);return Zs.radius=.7071067811865476+e,Zs.applyMatrix4(t.matrixWorld),this.intersectsSphere(Zs)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(dc.x=s.normal.x>0?t.max.x:t.min.x,dc.y=s.normal.y>0?t.max.y:t.min.y,dc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(dc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Sp=new Qt,zc=class i{constructor(){this.coordinateSystem=qn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Sp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new fs),n[s].setFromProjectionMatrix(Sp,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new fs),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var ps=class extends $n{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ot(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},kc=new C,Gc=new C,bp=new Qt,To=new Dr,fc=new wn,Tu=new C,wp=new C,Or=class extends je{constructor(t=new _e,e=new ps){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)kc.fromBufferAttribute(e,s-1),Gc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=kc.distanceTo(Gc);t.setAttribute("lineDistance",new ee(n,1))}else Pt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),fc.copy(n.boundingSphere),fc.applyMatrix4(s),fc.radius+=r,t.ray.intersectsSphere(fc)===!1)return;bp.copy(s).invert(),To.copy(t.ray).applyMatrix4(bp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let g=f,m=p-1;g<m;g+=l){let x=h.getX(g),_=h.getX(g+1),M=pc(this,t,To,c,x,_,g);M&&e.push(M)}if(this.isLineLoop){let g=h.getX(p-1),m=h.getX(f),x=pc(this,t,To,c,g,m,p-1);x&&e.push(x)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let g=f,m=p-1;g<m;g+=l){let x=pc(this,t,To,c,g,g+1,g);x&&e.push(x)}if(this.isLineLoop){let g=pc(this,t,To,c,p-1,f,p-1);g&&e.push(g)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function pc(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(kc.fromBufferAttribute(a,s),Gc.fromBufferAttribute(a,r),e.distanceSqToSegment(kc,Gc,Tu,wp)>n)return;Tu.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(Tu);if(!(l<t.near||l>t.far))return{distance:l,point:wp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Ap=new C,Ep=new C,Js=class extends Or{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Ap.fromBufferAttribute(e,s),Ep.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Ap.distanceTo(Ep);t.setAttribute("lineDistance",new ee(n,1))}else Pt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Fr=class extends $n{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ot(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Tp=new Qt,Uu=new Dr,mc=new wn,gc=new C,Vo=class extends je{constructor(t=new _e,e=new Fr){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),mc.copy(n.boundingSphere),mc.applyMatrix4(s),mc.radius+=r,t.ray.intersectsSphere(mc)===!1)return;Tp.copy(s).invert(),Uu.copy(t.ray).applyMatrix4(Tp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=n.index,u=n.attributes.position;if(l!==null){let d=Math.max(0,o.start),f=Math.min(l.count,o.start+o.count);for(let p=d,g=f;p<g;p++){let m=l.getX(p);gc.fromBufferAttribute(u,m),Rp(gc,m,c,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let p=d,g=f;p<g;p++)gc.fromBufferAttribute(u,p),Rp(gc,p,c,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Rp(i,t,e,n,s,r,o){let a=Uu.distanceSqToPoint(i);if(a<e){let c=new C;Uu.closestPointToPoint(i,c),c.applyMatrix4(n);let l=s.ray.origin.distanceTo(c);if(l<s.near||l>s.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var Ho=class extends bn{constructor(t=[],e=tr,n,s,r,o,a,c,l,h){super(t,e,n,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Hi=class extends bn{constructor(t,e,n=ai,s,r,o,a=$e,c=$e,l,h=Vi,u=1){if(h!==Vi&&h!==Xi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Lr(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Wo=class extends Hi{constructor(t,e=ai,n=tr,s,r,o=$e,a=$e,c,l=Vi){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,c,l),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},qo=class extends bn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Wi=class i extends _e{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new ee(l,3)),this.setAttribute("normal",new ee(h,3)),this.setAttribute("uv",new ee(u,2));function p(g,m,x,_,M,v,b,w,y,S,I){let T=v/y,L=b/S,N=v/2,F=b/2,P=w/2,B=y+1,G=S+1,H=0,j=0,W=new C;for(let Y=0;Y<G;Y++){let tt=Y*L-F;for(let gt=0;gt<B;gt++){let wt=gt*T-N;W[g]=wt*_,W[m]=tt*M,W[x]=P,l.push(W.x,W.y,W.z),W[g]=0,W[m]=0,W[x]=w>0?1:-1,h.push(W.x,W.y,W.z),u.push(gt/y),u.push(1-Y/S),H+=1}}for(let Y=0;Y<S;Y++)for(let tt=0;tt<y;tt++){let gt=d+tt+B*Y,wt=d+tt+B*(Y+1),X=d+(tt+1)+B*(Y+1),rt=d+(tt+1)+B*Y;c.push(gt,wt,rt),c.push(wt,X,rt),j+=6}a.addGroup(f,j,I),f+=j,d+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var oi=class i extends _e{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,g=[],m=n/2,x=0;_(),o===!1&&(t>0&&M(!0),e>0&&M(!1)),this.setIndex(h),this.setAttribute("position",new ee(u,3)),this.setAttribute("normal",new ee(d,3)),this.setAttribute("uv",new ee(f,2));function _(){let v=new C,b=new C,w=0,y=(e-t)/n;for(let S=0;S<=r;S++){let I=[],T=S/r,L=T*(e-t)+t;for(let N=0;N<=s;N++){let F=N/s,P=F*c+a,B=Math.sin(P),G=Math.cos(P);b.x=L*B,b.y=-T*n+m,b.z=L*G,u.push(b.x,b.y,b.z),v.set(B,y,G).normalize(),d.push(v.x,v.y,v.z),f.push(F,1-T),I.push(p++)}g.push(I)}for(let S=0;S<s;S++)for(let I=0;I<r;I++){let T=g[I][S],L=g[I+1][S],N=g[I+1][S+1],F=g[I][S+1];(t>0||I!==0)&&(h.push(T,L,F),w+=3),(e>0||I!==r-1)&&(h.push(L,N,F),w+=3)}l.addGroup(x,w,0),x+=w}function M(v){let b=p,w=new Gt,y=new C,S=0,I=v===!0?t:e,T=v===!0?1:-1;for(let N=1;N<=s;N++)u.push(0,m*T,0),d.push(0,T,0),f.push(.5,.5),p++;let L=p;for(let N=0;N<=s;N++){let P=N/s*c+a,B=Math.cos(P),G=Math.sin(P);y.x=I*G,y.y=m*T,y.z=I*B,u.push(y.x,y.y,y.z),d.push(0,T,0),w.x=B*.5+.5,w.y=G*.5*T+.5,f.push(w.x,w.y),p++}for(let N=0;N<s;N++){let F=b+N,P=L+N;v===!0?h.push(P,P+1,F):h.push(P+1,P,F),S+=3}l.addGroup(x,S,v===!0?1:2),x+=S}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ms=class i extends oi{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Vc=class i extends _e{constructor(t=[],e=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:n,detail:s};let r=[],o=[];a(s),l(n),h(),this.setAttribute("position",new ee(r,3)),this.setAttribute("normal",new ee(r.slice(),3)),this.setAttribute("uv",new ee(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(_){let M=new C,v=new C,b=new C;for(let w=0;w<e.length;w+=3)f(e[w+0],M),f(e[w+1],v),f(e[w+2],b),c(M,v,b,_)}function c(_,M,v,b){let w=b+1,y=[];for(let S=0;S<=w;S++){y[S]=[];let I=_.clone().lerp(v,S/w),T=M.clone().lerp(v,S/w),L=w-S;for(let N=0;N<=L;N++)N===0&&S===w?y[S][N]=I:y[S][N]=I.clone().lerp(T,N/L)}for(let S=0;S<w;S++)for(let I=0;I<2*(w-S)-1;I++){let T=Math.floor(I/2);I%2===0?(d(y[S][T+1]),d(y[S+1][T]),d(y[S][T])):(d(y[S][T+1]),d(y[S+1][T+1]),d(y[S+1][T]))}}function l(_){let M=new C;for(let v=0;v<r.length;v+=3)M.x=r[v+0],M.y=r[v+1],M.z=r[v+2],M.normalize().multiplyScalar(_),r[v+0]=M.x,r[v+1]=M.y,r[v+2]=M.z}function h(){let _=new C;for(let M=0;M<r.length;M+=3){_.x=r[M+0],_.y=r[M+1],_.z=r[M+2];let v=m(_)/2/Math.PI+.5,b=x(_)/Math.PI+.5;o.push(v,1-b)}p(),u()}function u(){for(let _=0;_<o.length;_+=6){let M=o[_+0],v=o[_+2],b=o[_+4],w=Math.max(M,v,b),y=Math.min(M,v,b);w>.9&&y<.1&&(M<.2&&(o[_+0]+=1),v<.2&&(o[_+2]+=1),b<.2&&(o[_+4]+=1))}}function d(_){r.push(_.x,_.y,_.z)}function f(_,M){let v=_*3;M.x=t[v+0],M.y=t[v+1],M.z=t[v+2]}function p(){let _=new C,M=new C,v=new C,b=new C,w=new Gt,y=new Gt,S=new Gt;for(let I=0,T=0;I<r.length;I+=9,T+=6){_.set(r[I+0],r[I+1],r[I+2]),M.set(r[I+3],r[I+4],r[I+5]),v.set(r[I+6],r[I+7],r[I+8]),w.set(o[T+0],o[T+1]),y.set(o[T+2],o[T+3]),S.set(o[T+4],o[T+5]),b.copy(_).add(M).add(v).divideScalar(3);let L=m(b);g(w,T+0,_,L),g(y,T+2,M,L),g(S,T+4,v,L)}}function g(_,M,v,b){b<0&&_.x===1&&(o[M]=_.x-1),v.x===0&&v.z===0&&(o[M]=b/2/Math.PI+.5)}function m(_){return Math.atan2(_.z,-_.x)}function x(_){return Math.atan2(-_.y,Math.sqrt(_.x*_.x+_.z*_.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.vertices,t.indices,t.radius,t.detail)}};var xc=new C,_c=new C,Ru=new C,yc=new ki,Br=class extends _e{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(Er*e),o=t.getIndex(),a=t.getAttribute("position"),c=o?o.count:a.count,l=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<c;p+=3){o?(l[0]=o.getX(p),l[1]=o.getX(p+1),l[2]=o.getX(p+2)):(l[0]=p,l[1]=p+1,l[2]=p+2);let{a:g,b:m,c:x}=yc;if(g.fromBufferAttribute(a,l[0]),m.fromBufferAttribute(a,l[1]),x.fromBufferAttribute(a,l[2]),yc.getNormal(Ru),u[0]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let _=0;_<3;_++){let M=(_+1)%3,v=u[_],b=u[M],w=yc[h[_]],y=yc[h[M]],S=`${v}_${b}`,I=`${b}_${v}`,T=d.get(I);T?(Ru.dot(T.normal)<=r&&(f.push(w.x,w.y,w.z),f.push(y.x,y.y,y.z)),d.set(I,null)):d.has(S)||d.set(S,{index0:l[_],index1:l[M],normal:Ru.clone()})}}for(let p of d.values())if(p){let{index0:g,index1:m}=p;xc.fromBufferAttribute(a,g),_c.fromBufferAttribute(a,m),f.push(xc.x,xc.y,xc.z),f.push(_c.x,_c.y,_c.z)}this.setAttribute("position",new ee(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var Xo=class i extends Vc{constructor(t=1,e=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new i(t.radius,t.detail)}},Ks=class i extends _e{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),c=Math.floor(s),l=a+1,h=c+1,u=t/a,d=e/c,f=[],p=[],g=[],m=[];for(let x=0;x<h;x++){let _=x*d-o;for(let M=0;M<l;M++){let v=M*u-r;p.push(v,-_,0),g.push(0,0,1),m.push(M/a),m.push(1-x/c)}}for(let x=0;x<c;x++)for(let _=0;_<a;_++){let M=_+l*x,v=_+l*(x+1),b=_+1+l*(x+1),w=_+1+l*x;f.push(M,v,w),f.push(v,b,w)}this.setIndex(f),this.setAttribute("position",new ee(p,3)),this.setAttribute("normal",new ee(g,3)),this.setAttribute("uv",new ee(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var Dn=class i extends _e{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let c=Math.min(o+a,Math.PI),l=0,h=[],u=new C,d=new C,f=[],p=[],g=[],m=[];for(let x=0;x<=n;x++){let _=[],M=x/n,v=o+M*a,b=t*Math.cos(v),w=Math.sqrt(t*t-b*b),y=0;x===0&&o===0?y=.5/e:x===n&&c===Math.PI&&(y=-.5/e);for(let S=0;S<=e;S++){let I=S/e,T=s+I*r;u.x=-w*Math.cos(T),u.y=b,u.z=w*Math.sin(T),p.push(u.x,u.y,u.z),d.copy(u).normalize(),g.push(d.x,d.y,d.z),m.push(I+y,1-M),_.push(l++)}h.push(_)}for(let x=0;x<n;x++)for(let _=0;_<e;_++){let M=h[x][_+1],v=h[x][_],b=h[x+1][_],w=h[x+1][_+1];(x!==0||o>0)&&f.push(M,v,w),(x!==n-1||c<Math.PI)&&f.push(v,b,w)}this.setIndex(f),this.setAttribute("position",new ee(p,3)),this.setAttribute("normal",new ee(g,3)),this.setAttribute("uv",new ee(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var $o=class i extends _e{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let c=[],l=[],h=[],u=[],d=new C,f=new C,p=new C;for(let g=0;g<=n;g++){let m=o+g/n*a;for(let x=0;x<=s;x++){let _=x/s*r;f.x=(t+e*Math.cos(m))*Math.cos(_),f.y=(t+e*Math.cos(m))*Math.sin(_),f.z=e*Math.sin(m),l.push(f.x,f.y,f.z),d.x=t*Math.cos(_),d.y=t*Math.sin(_),p.subVectors(f,d).normalize(),h.push(p.x,p.y,p.z),u.push(x/s),u.push(g/n)}}for(let g=1;g<=n;g++)for(let m=1;m<=s;m++){let x=(s+1)*g+m-1,_=(s+1)*(g-1)+m-1,M=(s+1)*(g-1)+m,v=(s+1)*g+m;c.push(x,_,v),c.push(_,M,v)}this.setIndex(c),this.setAttribute("position",new ee(l,3)),this.setAttribute("normal",new ee(h,3)),this.setAttribute("uv",new ee(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};var Yo=class extends _e{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,s=new C,r=new C;if(t.index!==null){let o=t.attributes.position,a=t.index,c=t.groups;c.length===0&&(c=[{start:0,count:a.count,materialIndex:0}]);for(let l=0,h=c.length;l<h;++l){let u=c[l],d=u.start,f=u.count;for(let p=d,g=d+f;p<g;p+=3)for(let m=0;m<3;m++){let x=a.getX(p+m),_=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,x),r.fromBufferAttribute(o,_),Cp(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,c=o.count/3;a<c;a++)for(let l=0;l<3;l++){let h=3*a+l,u=3*a+(l+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),Cp(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new ee(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function Cp(i,t,e){let n=`${i.x},${i.y},${i.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${i.x},${i.y},${i.z}`;return e.has(n)===!0||e.has(s)===!0?!1:(e.add(n),e.add(s),!0)}function nr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Ip(s))s.isRenderTargetTexture?(Pt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Ip(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function hn(i){let t={};for(let e=0;e<i.length;e++){let n=nr(i[e]);for(let s in n)t[s]=n[s]}return t}function Ip(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Gy(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function pd(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:jt.workingColorSpace}var pa={clone:nr,merge:hn},Vy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Hy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Yn=class extends $n{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Vy,this.fragmentShader=Hy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=nr(t.uniforms),this.uniformsGroups=Gy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Ot().setHex(s.value);break;case"v2":this.uniforms[n].value=new Gt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new C().fromArray(s.value);break;case"v4":this.uniforms[n].value=new ce().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Ft().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Hc=class extends Yn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Zo=class extends $n{constructor(t){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new Ot(16777215),this.specular=new Ot(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ot(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Wr,this.normalScale=new Gt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Mi,this.combine=oa,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.specular.copy(t.specular),this.shininess=t.shininess,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var gn=class extends $n{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ot(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ot(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Wr,this.normalScale=new Gt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Mi,this.combine=oa,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Wc=class extends $n{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=cm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},qc=class extends $n{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}},Jo=class extends $n{constructor(t){super(),this.isMeshMatcapMaterial=!0,this.defines={MATCAP:""},this.type="MeshMatcapMaterial",this.color=new Ot(16777215),this.matcap=null,this.map=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Wr,this.normalScale=new Gt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.alphaMap=null,this.wireframe=!1,this.wireframeLinewidth=1,this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={MATCAP:""},this.color.copy(t.color),this.matcap=t.matcap,this.map=t.map,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.alphaMap=t.alphaMap,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.flatShading=t.flatShading,this.fog=t.fog,this}};function Mr(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function vc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var gs=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Xc=class extends gs{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Lu,endingEnd:Lu}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Nu:r=t,a=2*e-n;break;case Du:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Nu:o=t,c=2*n-e;break;case Du:o=1,c=n+s[1]-s[0];break;default:o=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),g=p*p,m=g*p,x=-d*m+2*d*g-d*p,_=(1+d)*m+(-1.5-2*d)*g+(-.5+d)*p+1,M=(-1-f)*m+(1.5+f)*g+.5*p,v=f*m-f*g;for(let b=0;b!==a;++b)r[b]=x*o[h+b]+_*o[l+b]+M*o[c+b]+v*o[u+b];return r}},$c=class extends gs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(n-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[l+d]*u+o[c+d]*h;return r}},Yc=class extends gs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Zc=class extends gs{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-e)/(s-e),g=1-p;for(let m=0;m!==a;++m)r[m]=o[l+m]*g+o[c+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let g=o[l+p],m=o[c+p],x=f*d+p*2,_=u[x],M=u[x+1],v=t*d+p*2,b=h[v],w=h[v+1],y=qy(n,e,_,b,s);r[p]=Mm(y,g,M,w,m)}return r}};function Mm(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function Wy(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function qy(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=Mm(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let c=Wy(r,t,e,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var Un=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Mr(e,this.TimeBufferType),this.values=Mr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Mr(t.times,Array),values:Mr(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),vc(t.settings)&&(n.settings={inTangents:Mr(t.settings.inTangents,Array),outTangents:Mr(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Yc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new $c(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Xc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Zc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Io:e=this.InterpolantFactoryMethodDiscrete;break;case Uc:e=this.InterpolantFactoryMethodLinear;break;case wc:e=this.InterpolantFactoryMethodSmooth;break;case Pu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Pt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Io;case this.InterpolantFactoryMethodLinear:return Uc;case this.InterpolantFactoryMethodSmooth:return wc;case this.InterpolantFactoryMethodBezier:return Pu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;vc(this.settings)&&(Pp(this.settings.inTangents,t),Pp(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;vc(this.settings)&&(Lp(this.settings.inTangents,t),Lp(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Ut("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Ut("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){Ut("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){Ut("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&oy(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){Ut("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===wc,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(s)c=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let g=e[u+p];if(g!==e[d+p]||g!==e[f+p]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,vc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Pp(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Lp(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}Un.prototype.ValueTypeName="";Un.prototype.TimeBufferType=Float32Array;Un.prototype.ValueBufferType=Float32Array;Un.prototype.DefaultInterpolation=Uc;var xs=class extends Un{constructor(t,e,n){super(t,e,n)}};xs.prototype.ValueTypeName="bool";xs.prototype.ValueBufferType=Array;xs.prototype.DefaultInterpolation=Io;xs.prototype.InterpolantFactoryMethodLinear=void 0;xs.prototype.InterpolantFactoryMethodSmooth=void 0;var Jc=class extends Un{constructor(t,e,n,s){super(t,e,n,s)}};Jc.prototype.ValueTypeName="color";var Kc=class extends Un{constructor(t,e,n,s){super(t,e,n,s)}};Kc.prototype.ValueTypeName="number";var jc=class extends gs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-e)/(s-e),l=t*a;for(let h=l+a;l!==h;l+=4)ae.slerpFlat(r,0,o,l-a,o,l,c);return r}},Ko=class extends Un{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new jc(this.times,this.values,this.getValueSize(),t)}};Ko.prototype.ValueTypeName="quaternion";Ko.prototype.InterpolantFactoryMethodSmooth=void 0;var _s=class extends Un{constructor(t,e,n){super(t,e,n)}};_s.prototype.ValueTypeName="string";_s.prototype.ValueBufferType=Array;_s.prototype.DefaultInterpolation=Io;_s.prototype.InterpolantFactoryMethodLinear=void 0;_s.prototype.InterpolantFactoryMethodSmooth=void 0;var Qc=class extends Un{constructor(t,e,n,s){super(t,e,n,s)}};Qc.prototype.ValueTypeName="vector";var tl=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,u){return l.push(h,u),this},this.removeHandler=function(h){let u=l.indexOf(h);return u!==-1&&l.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=l.length;u<d;u+=2){let f=l[u],p=l[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Sm=new tl,el=class{constructor(t){this.manager=t!==void 0?t:Sm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};el.DEFAULT_MATERIAL_NAME="__DEFAULT";var jo=class extends je{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Ot(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Cu=new Qt,Np=new C,Dp=new C,nl=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Gt(512,512),this.mapType=An,this.map=null,this.mapPass=null,this.matrix=new Qt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new fs,this._frameExtents=new Gt(1,1),this._viewportCount=1,this._viewports=[new ce(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Np.setFromMatrixPosition(t.matrixWorld),e.position.copy(Np),Dp.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Dp),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Cu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Cu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===Cr||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply(Cu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Mc=new C,Sc=new ae,_i=new C,Qo=class extends je{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qt,this.projectionMatrix=new Qt,this.projectionMatrixInverse=new Qt,this.coordinateSystem=qn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Mc,Sc,_i),_i.x===1&&_i.y===1&&_i.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Mc,Sc,_i.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Mc,Sc,_i),_i.x===1&&_i.y===1&&_i.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Mc,Sc,_i.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ds=new C,Up=new Gt,Op=new Gt,pn=class extends Qo{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Pr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Er*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Pr*2*Math.atan(Math.tan(Er*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){ds.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ds.x,ds.y).multiplyScalar(-t/ds.z),ds.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ds.x,ds.y).multiplyScalar(-t/ds.z)}getViewSize(t,e){return this.getViewBounds(t,Up,Op),e.subVectors(Op,Up)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Er*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ta=class extends Qo{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Ou=class extends nl{constructor(){super(new ta(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ea=class extends jo{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(je.DEFAULT_UP),this.updateMatrix(),this.target=new je,this.shadow=new Ou}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},na=class extends jo{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var ia=class extends _e{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var Sr=-90,br=1,zr=class extends je{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new pn(Sr,br,t,e);s.layers=this.layers,this.add(s);let r=new pn(Sr,br,t,e);r.layers=this.layers,this.add(r);let o=new pn(Sr,br,t,e);o.layers=this.layers,this.add(o);let a=new pn(Sr,br,t,e);a.layers=this.layers,this.add(a);let c=new pn(Sr,br,t,e);c.layers=this.layers,this.add(c);let l=new pn(Sr,br,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===qn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Cr)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let g=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=g,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},il=class extends pn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var md="\\[\\]\\.:\\/",Xy=new RegExp("["+md+"]","g"),gd="[^"+md+"]",$y="[^"+md.replace("\\.","")+"]",Yy=/((?:WC+[\/:])*)/.source.replace("WC",gd),Zy=/(WCOD+)?/.source.replace("WCOD",$y),Jy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",gd),Ky=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",gd),jy=new RegExp("^"+Yy+Zy+Jy+Ky+"$"),Qy=["material","materials","bones","map"],Fu=class{constructor(t,e,n){let s=n||Se.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Se=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Xy,"")}static parseTrackName(t){let e=jy.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Qy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=n(a.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Pt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){Ut("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Ut("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Ut("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Ut("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Ut("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Ut("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){Ut("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;Ut("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Ut("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Ut("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Se.Composite=Fu;Se.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Se.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Se.prototype.GetterByBindingType=[Se.prototype._getValue_direct,Se.prototype._getValue_array,Se.prototype._getValue_arrayElement,Se.prototype._getValue_toArray];Se.prototype.SetterByBindingTypeAndVersioning=[[Se.prototype._setValue_direct,Se.prototype._setValue_direct_setNeedsUpdate,Se.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Se.prototype._setValue_array,Se.prototype._setValue_array_setNeedsUpdate,Se.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Se.prototype._setValue_arrayElement,Se.prototype._setValue_arrayElement_setNeedsUpdate,Se.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Se.prototype._setValue_fromArray,Se.prototype._setValue_fromArray_setNeedsUpdate,Se.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var H3=new Float32Array(1);var ys=class extends ko{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var Bu=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Fp=new C,bc=new C,wr=new C,Ar=new C,Iu=new C,tv=new C,ev=new C,sa=class{constructor(t=new C,e=new C){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){Fp.subVectors(t,this.start),bc.subVectors(this.end,this.start);let n=bc.dot(bc);if(n===0)return 0;let r=bc.dot(Fp)/n;return e&&(r=Ht(r,0,1)),r}closestPointToPoint(t,e,n){let s=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=tv,n=ev){let s=10000000000000001e-32,r,o,a=this.start,c=t.start,l=this.end,h=t.end;wr.subVectors(l,a),Ar.subVectors(h,c),Iu.subVectors(a,c);let u=wr.dot(wr),d=Ar.dot(Ar),f=Ar.dot(Iu);if(u<=s&&d<=s)return e.copy(a),n.copy(c),e.distanceToSquared(n);if(u<=s)r=0,o=f/d,o=Ht(o,0,1);else{let p=wr.dot(Iu);if(d<=s)o=0,r=Ht(-p/u,0,1);else{let g=wr.dot(Ar),m=u*d-g*g;m!==0?r=Ht((g*f-p*d)/m,0,1):r=0,o=(g*r+f)/d,o<0?(o=0,r=Ht(-p/u,0,1)):o>1&&(o=1,r=Ht((g-p)/u,0,1))}}return e.copy(a).addScaledVector(wr,r),n.copy(c).addScaledVector(Ar,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};function xd(i,t,e,n){let s=nv(n);switch(e){case id:return i*t;case hl:return i*t/s.components*s.byteLength;case ul:return i*t/s.components*s.byteLength;case Ms:return i*t*2/s.components*s.byteLength;case dl:return i*t*2/s.components*s.byteLength;case sd:return i*t*3/s.components*s.byteLength;case li:return i*t*4/s.components*s.byteLength;case fl:return i*t*4/s.components*s.byteLength;case ca:case la:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case ha:case ua:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ml:case xl:return Math.max(i,16)*Math.max(t,8)/4;case pl:case gl:return Math.max(i,8)*Math.max(t,8)/2;case _l:case yl:case Ml:case Sl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case vl:case da:case bl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case wl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Al:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case El:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Tl:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Rl:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Cl:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Il:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Pl:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Ll:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Nl:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Dl:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Ul:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Ol:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Fl:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Bl:case zl:case kl:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Gl:case Vl:return Math.ceil(i/4)*Math.ceil(t/4)*8;case fa:case Hl:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function nv(i){switch(i){case An:case Qu:return{byteLength:1,components:1};case Hr:case td:case ci:return{byteLength:2,components:1};case cl:case ll:return{byteLength:2,components:4};case ai:case al:case Zn:return{byteLength:4,components:1};case ed:case nd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Pt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Wm(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function av(i){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,u=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,h),a.onUploadCallback();let f;if(l instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=i.SHORT;else if(l instanceof Uint32Array)f=i.UNSIGNED_INT;else if(l instanceof Int32Array)f=i.INT;else if(l instanceof Int8Array)f=i.BYTE;else if(l instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,c,l){let h=c.array,u=c.updateRanges;if(i.bindBuffer(l,a),u.length===0)i.bufferSubData(l,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],g=u[f];g.start<=p.start+p.count+1?p.count=Math.max(p.count,g.start+g.count-p.start):(++d,u[d]=g)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let g=u[f];i.bufferSubData(l,g.start*h.BYTES_PER_ELEMENT,h,g.start,g.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(i.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var cv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,lv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,hv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,uv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,dv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,fv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,pv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,mv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,gv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,xv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,_v=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,yv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,vv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Mv=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Sv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,bv=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,wv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Av=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ev=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Tv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Rv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Cv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Iv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Pv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Lv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Nv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Dv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Uv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Ov=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Fv="gl_FragColor = linearToOutputTexel( gl_FragColor );",Bv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,zv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,kv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Gv=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Vv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Hv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Wv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,qv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Xv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,$v=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Yv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Zv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Jv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Kv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,jv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Qv=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,tM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,eM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,nM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,iM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,sM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,rM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,oM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,aM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,cM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,lM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,hM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,uM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,dM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,fM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,pM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,mM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,gM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,xM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,_M=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,yM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,vM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,MM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,SM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,bM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,wM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,AM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,EM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,TM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,RM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,CM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,IM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,PM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,LM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,NM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,DM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,UM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,OM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,FM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,BM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,zM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,kM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,GM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,VM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,HM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,WM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,qM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,XM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,$M=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,YM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,ZM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,JM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,KM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,jM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,QM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,tS=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,eS=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,nS=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,iS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,sS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,rS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,oS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,aS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,cS=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,hS=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,uS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,dS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,pS=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,mS=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,gS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,xS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,_S=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,vS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,MS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,SS=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,wS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,AS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,ES=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,TS=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,RS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,CS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,IS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,PS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,LS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,NS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,DS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,US=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,OS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,FS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,BS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,zS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,kS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,$t={alphahash_fragment:cv,alphahash_pars_fragment:lv,alphamap_fragment:hv,alphamap_pars_fragment:uv,alphatest_fragment:dv,alphatest_pars_fragment:fv,aomap_fragment:pv,aomap_pars_fragment:mv,batching_pars_vertex:gv,batching_vertex:xv,begin_vertex:_v,beginnormal_vertex:yv,bsdfs:vv,iridescence_fragment:Mv,bumpmap_pars_fragment:Sv,clipping_planes_fragment:bv,clipping_planes_pars_fragment:wv,clipping_planes_pars_vertex:Av,clipping_planes_vertex:Ev,color_fragment:Tv,color_pars_fragment:Rv,color_pars_vertex:Cv,color_vertex:Iv,common:Pv,defaultnormal_vertex:Lv,displacementmap_pars_vertex:Nv,displacementmap_vertex:Dv,emissivemap_fragment:Uv,emissivemap_pars_fragment:Ov,colorspace_fragment:Fv,colorspace_pars_fragment:Bv,envmap_fragment:zv,envmap_common_pars_fragment:kv,envmap_pars_fragment:Gv,envmap_pars_vertex:Vv,envmap_physical_pars_fragment:Qv,envmap_vertex:Hv,fog_vertex:Wv,fog_pars_vertex:qv,fog_fragment:Xv,fog_pars_fragment:$v,gradientmap_pars_fragment:Yv,lightmap_pars_fragment:Zv,lights_lambert_fragment:Jv,lights_lambert_pars_fragment:Kv,lights_pars_begin:jv,lights_toon_fragment:tM,lights_toon_pars_fragment:eM,lights_phong_fragment:nM,lights_phong_pars_fragment:iM,lights_physical_fragment:sM,lights_physical_pars_fragment:rM,lights_fragment_begin:oM,lights_fragment_maps:aM,lights_fragment_end:cM,lightprobes_pars_fragment:lM,logdepthbuf_fragment:hM,logdepthbuf_pars_fragment:uM,logdepthbuf_pars_vertex:dM,logdepthbuf_vertex:fM,map_fragment:pM,map_pars_fragment:mM,map_particle_fragment:gM,map_particle_pars_fragment:xM,metalnessmap_fragment:_M,metalnessmap_pars_fragment:yM,morphinstance_vertex:vM,morphcolor_vertex:MM,morphnormal_vertex:SM,morphtarget_pars_vertex:bM,morphtarget_vertex:wM,normal_fragment_begin:AM,normal_fragment_maps:EM,normal_pars_fragment:TM,normal_pars_vertex:RM,normal_vertex:CM,normalmap_pars_fragment:IM,clearcoat_normal_fragment_begin:PM,clearcoat_normal_fragment_maps:LM,clearcoat_pars_fragment:NM,iridescence_pars_fragment:DM,opaque_fragment:UM,packing:OM,premultiplied_alpha_fragment:FM,project_vertex:BM,dithering_fragment:zM,dithering_pars_fragment:kM,roughnessmap_fragment:GM,roughnessmap_pars_fragment:VM,shadowmap_pars_fragment:HM,shadowmap_pars_vertex:WM,shadowmap_vertex:qM,shadowmask_pars_fragment:XM,skinbase_vertex:$M,skinning_pars_vertex:YM,skinning_vertex:ZM,skinnormal_vertex:JM,specularmap_fragment:KM,specularmap_pars_fragment:jM,tonemapping_fragment:QM,tonemapping_pars_fragment:tS,transmission_fragment:eS,transmission_pars_fragment:nS,uv_pars_fragment:iS,uv_pars_vertex:sS,uv_vertex:rS,worldpos_vertex:oS,background_vert:aS,background_frag:cS,backgroundCube_vert:lS,backgroundCube_frag:hS,cube_vert:uS,cube_frag:dS,depth_vert:fS,depth_frag:pS,distance_vert:mS,distance_frag:gS,equirect_vert:xS,equirect_frag:_S,linedashed_vert:yS,linedashed_frag:vS,meshbasic_vert:MS,meshbasic_frag:SS,meshlambert_vert:bS,meshlambert_frag:wS,meshmatcap_vert:AS,meshmatcap_frag:ES,meshnormal_vert:TS,meshnormal_frag:RS,meshphong_vert:CS,meshphong_frag:IS,meshphysical_vert:PS,meshphysical_frag:LS,meshtoon_vert:NS,meshtoon_frag:DS,points_vert:US,points_frag:OS,shadow_vert:FS,shadow_frag:BS,sprite_vert:zS,sprite_frag:kS},ft={common:{diffuse:{value:new Ot(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ft},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ft}},envmap:{envMap:{value:null},envMapRotation:{value:new Ft},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ft}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ft}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ft},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ft},normalScale:{value:new Gt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ft},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ft}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ft}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ft}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ot(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ot(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0},uvTransform:{value:new Ft}},sprite:{diffuse:{value:new Ot(16777215)},opacity:{value:1},center:{value:new Gt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ft},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0}}},_n={basic:{uniforms:hn([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:$t.meshbasic_vert,fragmentShader:$t.meshbasic_frag},lambert:{uniforms:hn([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ot(0)},envMapIntensity:{value:1}}]),vertexShader:$t.meshlambert_vert,fragmentShader:$t.meshlambert_frag},phong:{uniforms:hn([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ot(0)},specular:{value:new Ot(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:$t.meshphong_vert,fragmentShader:$t.meshphong_frag},standard:{uniforms:hn([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new Ot(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:$t.meshphysical_vert,fragmentShader:$t.meshphysical_frag},toon:{uniforms:hn([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new Ot(0)}}]),vertexShader:$t.meshtoon_vert,fragmentShader:$t.meshtoon_frag},matcap:{uniforms:hn([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:$t.meshmatcap_vert,fragmentShader:$t.meshmatcap_frag},points:{uniforms:hn([ft.points,ft.fog]),vertexShader:$t.points_vert,fragmentShader:$t.points_frag},dashed:{uniforms:hn([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:$t.linedashed_vert,fragmentShader:$t.linedashed_frag},depth:{uniforms:hn([ft.common,ft.displacementmap]),vertexShader:$t.depth_vert,fragmentShader:$t.depth_frag},normal:{uniforms:hn([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:$t.meshnormal_vert,fragmentShader:$t.meshnormal_frag},sprite:{uniforms:hn([ft.sprite,ft.fog]),vertexShader:$t.sprite_vert,fragmentShader:$t.sprite_frag},background:{uniforms:{uvTransform:{value:new Ft},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:$t.background_vert,fragmentShader:$t.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ft}},vertexShader:$t.backgroundCube_vert,fragmentShader:$t.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:$t.cube_vert,fragmentShader:$t.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:$t.equirect_vert,fragmentShader:$t.equirect_frag},distance:{uniforms:hn([ft.common,ft.displacementmap,{referencePosition:{value:new C},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:$t.distance_vert,fragmentShader:$t.distance_frag},shadow:{uniforms:hn([ft.lights,ft.fog,{color:{value:new Ot(0)},opacity:{value:1}}]),vertexShader:$t.shadow_vert,fragmentShader:$t.shadow_frag}};_n.physical={uniforms:hn([_n.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ft},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ft},clearcoatNormalScale:{value:new Gt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ft},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ft},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ft},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ft},sheen:{value:0},sheenColor:{value:new Ot(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ft},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ft},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ft},transmissionSamplerSize:{value:new Gt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ft},attenuationDistance:{value:0},attenuationColor:{value:new Ot(0)},specularColor:{value:new Ot(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ft},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ft},anisotropyVector:{value:new Gt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ft}}]),vertexShader:$t.meshphysical_vert,fragmentShader:$t.meshphysical_frag};var Xl={r:0,b:0,g:0},GS=new Qt,qm=new Ft;qm.set(-1,0,0,0,1,0,0,0,1);function VS(i,t,e,n,s,r){let o=new Ot(0),a=s===!0?0:1,c,l,h=null,u=0,d=null;function f(_){let M=_.isScene===!0?_.background:null;if(M&&M.isTexture){let v=_.backgroundBlurriness>0;M=t.get(M,v)}return M}function p(_){let M=!1,v=f(_);v===null?m(o,a):v&&v.isColor&&(m(v,1),M=!0);let b=i.xr.getEnvironmentBlendMode();b==="additive"?e.buffers.color.setClear(0,0,0,1,r):b==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function g(_,M){let v=f(M);v&&v.isCubeTexture?(l===void 0&&(l=new Yt(new Wi(1,1,1),new Yn({name:"BackgroundCubeMaterial",uniforms:nr(_n.backgroundCube.uniforms),vertexShader:_n.backgroundCube.vertexShader,fragmentShader:_n.backgroundCube.fragmentShader,side:xn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(b,w,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=v,l.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(GS.makeRotationFromEuler(M.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(qm),l.material.toneMapped=jt.getTransfer(v.colorSpace)!==oe,(h!==v||u!==v.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=v,u=v.version,d=i.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null)):v&&v.isTexture&&(c===void 0&&(c=new Yt(new Ks(2,2),new Yn({name:"BackgroundMaterial",uniforms:nr(_n.background.uniforms),vertexShader:_n.background.vertexShader,fragmentShader:_n.background.fragmentShader,side:vs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=v,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.toneMapped=jt.getTransfer(v.colorSpace)!==oe,v.matrixAutoUpdate===!0&&v.updateMatrix(),c.material.uniforms.uvTransform.value.copy(v.matrix),(h!==v||u!==v.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=v,u=v.version,d=i.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null))}function m(_,M){_.getRGB(Xl,pd(i)),e.buffers.color.setClear(Xl.r,Xl.g,Xl.b,M,r)}function x(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,M=1){o.set(_),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,m(o,a)},render:p,addToRenderList:g,dispose:x}}function HS(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(L,N,F,P,B){let G=!1,H=u(L,P,F,N);r!==H&&(r=H,l(r.object)),G=f(L,P,F,B),G&&p(L,P,F,B),B!==null&&t.update(B,i.ELEMENT_ARRAY_BUFFER),(G||o)&&(o=!1,v(L,N,F,P),B!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(B).buffer))}function c(){return i.createVertexArray()}function l(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function u(L,N,F,P){let B=P.wireframe===!0,G=n[N.id];G===void 0&&(G={},n[N.id]=G);let H=L.isInstancedMesh===!0?L.id:0,j=G[H];j===void 0&&(j={},G[H]=j);let W=j[F.id];W===void 0&&(W={},j[F.id]=W);let Y=W[B];return Y===void 0&&(Y=d(c()),W[B]=Y),Y}function d(L){let N=[],F=[],P=[];for(let B=0;B<e;B++)N[B]=0,F[B]=0,P[B]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:N,enabledAttributes:F,attributeDivisors:P,object:L,attributes:{},index:null}}function f(L,N,F,P){let B=r.attributes,G=N.attributes,H=0,j=F.getAttributes();for(let W in j)if(j[W].location>=0){let tt=B[W],gt=G[W];if(gt===void 0&&(W==="instanceMatrix"&&L.instanceMatrix&&(gt=L.instanceMatrix),W==="instanceColor"&&L.instanceColor&&(gt=L.instanceColor)),tt===void 0||tt.attribute!==gt||gt&&tt.data!==gt.data)return!0;H++}return r.attributesNum!==H||r.index!==P}function p(L,N,F,P){let B={},G=N.attributes,H=0,j=F.getAttributes();for(let W in j)if(j[W].location>=0){let tt=G[W];tt===void 0&&(W==="instanceMatrix"&&L.instanceMatrix&&(tt=L.instanceMatrix),W==="instanceColor"&&L.instanceColor&&(tt=L.instanceColor));let gt={};gt.attribute=tt,tt&&tt.data&&(gt.data=tt.data),B[W]=gt,H++}r.attributes=B,r.attributesNum=H,r.index=P}function g(){let L=r.newAttributes;for(let N=0,F=L.length;N<F;N++)L[N]=0}function m(L){x(L,0)}function x(L,N){let F=r.newAttributes,P=r.enabledAttributes,B=r.attributeDivisors;F[L]=1,P[L]===0&&(i.enableVertexAttribArray(L),P[L]=1),B[L]!==N&&(i.vertexAttribDivisor(L,N),B[L]=N)}function _(){let L=r.newAttributes,N=r.enabledAttributes;for(let F=0,P=N.length;F<P;F++)N[F]!==L[F]&&(i.disableVertexAttribArray(F),N[F]=0)}function M(L,N,F,P,B,G,H){H===!0?i.vertexAttribIPointer(L,N,F,B,G):i.vertexAttribPointer(L,N,F,P,B,G)}function v(L,N,F,P){g();let B=P.attributes,G=F.getAttributes(),H=N.defaultAttributeValues;for(let j in G){let W=G[j];if(W.location>=0){let Y=B[j];if(Y===void 0&&(j==="instanceMatrix"&&L.instanceMatrix&&(Y=L.instanceMatrix),j==="instanceColor"&&L.instanceColor&&(Y=L.instanceColor)),Y!==void 0){let tt=Y.normalized,gt=Y.itemSize,wt=t.get(Y);if(wt===void 0)continue;let X=wt.buffer,rt=wt.type,xt=wt.bytesPerElement,At=rt===i.INT||rt===i.UNSIGNED_INT||Y.gpuType===al;if(Y.isInterleavedBufferAttribute){let pt=Y.data,Dt=pt.isInterleavedBuffer===!0?pt.stride:pt.itemSize,me=Y.offset;if(pt.isInstancedInterleavedBuffer||pt.isInstancedBufferAttribute){for(let Rt=0;Rt<W.locationSize;Rt++)x(W.location+Rt,pt.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=pt.meshPerAttribute*pt.count)}else for(let Rt=0;Rt<W.locationSize;Rt++)m(W.location+Rt);i.bindBuffer(i.ARRAY_BUFFER,X);for(let Rt=0;Rt<W.locationSize;Rt++)M(W.location+Rt,gt/W.locationSize,rt,tt,Dt*xt,(me+gt/W.locationSize*Rt)*xt,At)}else{if(Y.isInstancedBufferAttribute){for(let pt=0;pt<W.locationSize;pt++)x(W.location+pt,Y.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Y.meshPerAttribute*Y.count)}else for(let pt=0;pt<W.locationSize;pt++)m(W.location+pt);i.bindBuffer(i.ARRAY_BUFFER,X);for(let pt=0;pt<W.locationSize;pt++)M(W.location+pt,gt/W.locationSize,rt,tt,gt*xt,gt/W.locationSize*pt*xt,At)}}else if(H!==void 0){let tt=H[j];if(tt!==void 0)switch(tt.length){case 2:i.vertexAttrib2fv(W.location,tt);break;case 3:i.vertexAttrib3fv(W.location,tt);break;case 4:i.vertexAttrib4fv(W.location,tt);break;default:i.vertexAttrib1fv(W.location,tt)}}}}_()}function b(){I();for(let L in n){let N=n[L];for(let F in N){let P=N[F];for(let B in P){let G=P[B];for(let H in G)h(G[H].object),delete G[H];delete P[B]}}delete n[L]}}function w(L){if(n[L.id]===void 0)return;let N=n[L.id];for(let F in N){let P=N[F];for(let B in P){let G=P[B];for(let H in G)h(G[H].object),delete G[H];delete P[B]}}delete n[L.id]}function y(L){for(let N in n){let F=n[N];for(let P in F){let B=F[P];if(B[L.id]===void 0)continue;let G=B[L.id];for(let H in G)h(G[H].object),delete G[H];delete B[L.id]}}}function S(L){for(let N in n){let F=n[N],P=L.isInstancedMesh===!0?L.id:0,B=F[P];if(B!==void 0){for(let G in B){let H=B[G];for(let j in H)h(H[j].object),delete H[j];delete B[G]}delete F[P],Object.keys(F).length===0&&delete n[N]}}}function I(){T(),o=!0,r!==s&&(r=s,l(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:T,dispose:b,releaseStatesOfGeometry:w,releaseStatesOfObject:S,releaseStatesOfProgram:y,initAttributes:g,enableAttribute:m,disableUnusedAttributes:_}}function WS(i,t,e){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),e.update(l,n,1)}function o(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),e.update(l,n,h))}function a(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let f=0;f<h;f++)d+=l[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function qS(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==li&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let S=y===ci&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==An&&y!==Zn&&!S&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Pt("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Pt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Pt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),x=i.getParameter(i.MAX_VERTEX_ATTRIBS),_=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),b=i.getParameter(i.MAX_SAMPLES),w=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:g,maxCubemapSize:m,maxAttributes:x,maxVertexUniforms:_,maxVaryings:M,maxFragmentUniforms:v,maxSamples:b,samples:w}}function XS(i){let t=this,e=null,n=0,s=!1,r=!1,o=new si,a=new Ft,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,g=u.clipIntersection,m=u.clipShadows,x=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):l();else{let _=r?0:n,M=_*4,v=x.clippingState||null;c.value=v,v=h(p,d,M,f);for(let b=0;b!==M;++b)v[b]=e[b];x.clippingState=v,this.numIntersection=g?this.numPlanes:0,this.numPlanes+=_}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,p){let g=u!==null?u.length:0,m=null;if(g!==0){if(m=c.value,p!==!0||m===null){let x=f+g*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(m===null||m.length<x)&&(m=new Float32Array(x));for(let M=0,v=f;M!==g;++M,v+=4)o.copy(u[M]).applyMatrix4(_,a),o.normal.toArray(m,v),m[v+3]=o.constant}c.value=m,c.needsUpdate=!0}return t.numPlanes=g,t.numIntersection=0,m}}var xa=class extends Nn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Ho(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Wi(5,5,5),r=new Yn({name:"CubemapFromEquirect",uniforms:nr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:xn,blending:js});r.uniforms.tEquirect.value=e;let o=new Yt(s,r),a=e.minFilter;return e.minFilter===qi&&(e.minFilter=Be),new zr(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},bm=256,$S=3,YS=20,Xm=256,$m=16,ZS=3,JS=new C,KS=new Ot,Yl=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new zr(1,10,null),this._boxMesh=new Yt(new Wi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=JS}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,g=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,g===null&&(t.background=c.getClearColor(KS));let m=new zr(n,s,h);return m.position.copy(a),m.update(c,t),c.autoClear=u,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=p,t.background=g,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Em(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Am(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(bm,ud(t))}_fromTexture(t,e){t.mapping===tr||t.mapping===Vr?this._setSize(t.image.length===0?bm:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=wm(t,!1,!1),n=Math.log2(t)-$S;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=wm(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===tr||t.mapping===Vr?(this._cubemapMaterial===null&&(this._cubemapMaterial=Em()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Am()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=jS(),this._integrationMaterial=QS());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/$m);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-ZS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(Xm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=tb());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function wm(i,t,e){return new xa(i,{minFilter:qi,generateMipmaps:t,type:ci,colorSpace:Po,depthBuffer:e})}function _a(i,t,e){return new Yn({name:i,uniforms:t,vertexShader:$t.cube_vert,fragmentShader:e,side:xn,blending:js,depthTest:!1,depthWrite:!1})}function jS(){return _a("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Xm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function QS(){return _a("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:$m}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function tb(){return _a("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${YS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Am(){return _a("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Em(){return _a("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function eb(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===sl||f===rl)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let g=new xa(p.height);return g.fromEquirectangularTexture(i,d),t.set(d,g),d.addEventListener("dispose",l),a(g.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===sl||f===rl,g=f===tr||f===Vr;if(p||g){let m=e.get(d),x=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==x)return n===null&&(n=new Yl(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let _=d.image;return p&&_&&_.height>0||g&&_&&c(_)?(n===null&&(n=new Yl(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===sl?d.mapping=tr:f===rl&&(d.mapping=Vr),d}function c(d){let f=0,p=6;for(let g=0;g<p;g++)d[g]!==void 0&&f++;return f===p}function l(d){let f=d.target;f.removeEventListener("dispose",l);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function nb(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Ro("WebGLRenderer: "+n+" extension not supported."),s}}}function ib(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let g=r.get(p);g&&(t.remove(g),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function l(p,g){return s[g.id]!==void 0||(g.addEventListener("dispose",a),s[g.id]=new WeakRef(g),o.register(g,g.id,g),e.memory.geometries++),g}function h(p){let g=p.attributes;for(let m in g)t.update(g[m],i.ARRAY_BUFFER)}function u(p){let g=p.index,m=p.attributes.position,x=0;if(m===void 0)return;let _=g!==null?g.array.length:m.array.length/3-1,M=m.count>=65535?zo:Bo,v=new M(Math.ceil(_/3)*6,1),b=v.array;if(g!==null){let y=g.array;x=g.version;for(let S=0,I=0;S<_;S+=3){let T=y[S+0],L=y[S+1],N=y[S+2];b[I++]=T,b[I++]=L,b[I++]=L,b[I++]=N,b[I++]=N,b[I++]=T}}else{x=m.version;for(let y=0,S=0;y<_;y+=3){let I=y+0,T=y+1,L=y+2;b[S++]=I,b[S++]=T,b[S++]=T,b[S++]=L,b[S++]=L,b[S++]=I}}v.version=x;let w=r.get(p);w&&t.remove(w),r.set(p,v)}function d(p){let g=r.get(p);if(g){let m=p.index;m!==null&&g.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let g=s[p].deref();g!==void 0&&c(g)}}return{get:l,update:h,getWireframeAttribute:d,dispose:f}}function sb(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function c(u,d){i.drawElements(n,d,r,u*o),e.update(d,n,1)}function l(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let g=0;for(let m=0;m<f;m++)g+=d[m];e.update(g,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function rb(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:Ut("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function ob(i,t,e){let n=new WeakMap,s=new ce;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let I=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",I)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,g=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],x=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),g===!0&&(M=3);let v=a.attributes.position.count*M,b=1;v>t.maxTextureSize&&(b=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let w=new Float32Array(v*b*4*u),y=new Uo(w,v,b,u);y.type=Zn,y.needsUpdate=!0;let S=M*4;for(let T=0;T<u;T++){let L=m[T],N=x[T],F=_[T],P=v*b*4*T;for(let B=0;B<L.count;B++){let G=B*S;f===!0&&(s.fromBufferAttribute(L,B),w[P+G+0]=s.x,w[P+G+1]=s.y,w[P+G+2]=s.z,w[P+G+3]=0),p===!0&&(s.fromBufferAttribute(N,B),w[P+G+4]=s.x,w[P+G+5]=s.y,w[P+G+6]=s.z,w[P+G+7]=0),g===!0&&(s.fromBufferAttribute(F,B),w[P+G+8]=s.x,w[P+G+9]=s.y,w[P+G+10]=s.z,w[P+G+11]=F.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new Gt(v,b)},n.set(a,d),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let g=0;g<l.length;g++)f+=l[g];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(i,"morphTargetBaseInfluence",p),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function ab(i,t,e,n,s){let r=new WeakMap;function o(l){let h=s.render.frame,u=l.geometry,d=t.get(l,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var cb={[qu]:"LINEAR_TONE_MAPPING",[Xu]:"REINHARD_TONE_MAPPING",[$u]:"CINEON_TONE_MAPPING",[Yu]:"ACES_FILMIC_TONE_MAPPING",[Ju]:"AGX_TONE_MAPPING",[Ku]:"NEUTRAL_TONE_MAPPING",[Zu]:"CUSTOM_TONE_MAPPING"};function lb(i,t,e,n,s,r){let o=new Nn(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new _e;h.setAttribute("position",new ee([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new ee([0,2,0,0,2,0],2));let u=new Hc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Yt(h,u),f=new ta(-1,1,1,-1,0,1),p=null,g=null,m=!1,x,_=null,M=[],v=!1;this.setSize=function(b,w){o.setSize(b,w),a!==null&&a.setSize(b,w),c!==null&&c.setSize(b,w);for(let y=0;y<M.length;y++){let S=M[y];S.setSize&&S.setSize(b,w)}},this.setEffects=function(b){M=b,v=M.length>0&&M[0].isRenderPass===!0;let w=o.width,y=o.height;M.length>0&&a===null&&(a=new Nn(w,y,{type:ci,depthBuffer:!1,stencilBuffer:!1}),c=new Nn(w,y,{type:ci,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&M.some(I=>I.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&l===null&&(l=new Hi(w,y),r===!0&&(l.format=Xi,l.type=er)),o.dispose(),o.depthTexture=S?l:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let I=0;I<M.length;I++){let T=M[I];T.setSize&&T.setSize(w,y),S&&T.needsDepthTexture===!0&&T.setDepthTexture&&T.setDepthTexture(l)}},this.begin=function(b,w){if(m||b.toneMapping===bi&&M.length===0)return!1;if(_=w,w!==null){let y=w.width,S=w.height;(o.width!==y||o.height!==S)&&this.setSize(y,S)}return v===!1&&b.setRenderTarget(o),x=b.toneMapping,b.toneMapping=bi,!0},this.hasRenderPass=function(){return v},this.end=function(b,w){b.toneMapping=x,m=!0;let y=o,S=a;for(let I=0;I<M.length;I++){let T=M[I];T.enabled!==!1&&(T.render(b,S,y,w),T.needsSwap!==!1&&(y=S,S=S===a?c:a))}if(p!==b.outputColorSpace||g!==b.toneMapping){p=b.outputColorSpace,g=b.toneMapping,u.defines={},jt.getTransfer(p)===oe&&(u.defines.SRGB_TRANSFER="");let I=cb[g];I&&(u.defines[I]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,b.setRenderTarget(_),b.render(d,f),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),u.dispose()}}var Ym=new bn,Zm=new Hi(1,1),Jm=new Wo(1),Km=new Uo,jm=new Bc,Qm=new Ho,Tm=[],Rm=[],Cm=new Float32Array(16),Im=new Float32Array(9),Pm=new Float32Array(4);function Xr(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Tm[s];if(r===void 0&&(r=new Float32Array(s),Tm[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function ze(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function ke(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Jl(i,t){let e=Rm[t];e===void 0&&(e=new Int32Array(t),Rm[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function hb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function ub(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ze(e,t))return;i.uniform2fv(this.addr,t),ke(e,t)}}function db(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(ze(e,t))return;i.uniform3fv(this.addr,t),ke(e,t)}}function fb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ze(e,t))return;i.uniform4fv(this.addr,t),ke(e,t)}}function pb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(ze(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),ke(e,t)}else{if(ze(e,n))return;Pm.set(n),i.uniformMatrix2fv(this.addr,!1,Pm),ke(e,n)}}function mb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(ze(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),ke(e,t)}else{if(ze(e,n))return;Im.set(n),i.uniformMatrix3fv(this.addr,!1,Im),ke(e,n)}}function gb(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(ze(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),ke(e,t)}else{if(ze(e,n))return;Cm.set(n),i.uniformMatrix4fv(this.addr,!1,Cm),ke(e,n)}}function xb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function _b(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ze(e,t))return;i.uniform2iv(this.addr,t),ke(e,t)}}function yb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ze(e,t))return;i.uniform3iv(this.addr,t),ke(e,t)}}function vb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ze(e,t))return;i.uniform4iv(this.addr,t),ke(e,t)}}function Mb(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Sb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ze(e,t))return;i.uniform2uiv(this.addr,t),ke(e,t)}}function bb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ze(e,t))return;i.uniform3uiv(this.addr,t),ke(e,t)}}function wb(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ze(e,t))return;i.uniform4uiv(this.addr,t),ke(e,t)}}function Kl(i){return i.version===0&&(i.compareFunction=ad,i.needsUpdate=!0),i}function Ab(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Kl(Zm):r=Ym,e.setTexture2D(t||r,s)}function Eb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||jm,s)}function Tb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Kl(Jm):r=Qm,e.setTextureCube(t||r,s)}function Rb(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Km,s)}function Cb(i){switch(i){case 5126:return hb;case 35664:return ub;case 35665:return db;case 35666:return fb;case 35674:return pb;case 35675:return mb;case 35676:return gb;case 5124:case 35670:return xb;case 35667:case 35671:return _b;case 35668:case 35672:return yb;case 35669:case 35673:return vb;case 5125:return Mb;case 36294:return Sb;case 36295:return bb;case 36296:return wb;case 35678:case 36198:case 36298:case 36306:case 35682:return Ab;case 35679:case 36299:case 36307:return Eb;case 35680:case 36300:case 36308:case 36293:return Tb;case 36289:case 36303:case 36311:case 36292:return Rb}}function Ib(i,t){i.uniform1fv(this.addr,t)}function Pb(i,t){let e=Xr(t,this.size,2);i.uniform2fv(this.addr,e)}function Lb(i,t){let e=Xr(t,this.size,3);i.uniform3fv(this.addr,e)}function Nb(i,t){let e=Xr(t,this.size,4);i.uniform4fv(this.addr,e)}function Db(i,t){let e=Xr(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Ub(i,t){let e=Xr(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Ob(i,t){let e=Xr(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Fb(i,t){i.uniform1iv(this.addr,t)}function Bb(i,t){i.uniform2iv(this.addr,t)}function zb(i,t){i.uniform3iv(this.addr,t)}function kb(i,t){i.uniform4iv(this.addr,t)}function Gb(i,t){i.uniform1uiv(this.addr,t)}function Vb(i,t){i.uniform2uiv(this.addr,t)}function Hb(i,t){i.uniform3uiv(this.addr,t)}function Wb(i,t){i.uniform4uiv(this.addr,t)}function qb(i,t,e){let n=this.cache,s=t.length,r=Jl(e,s);ze(n,r)||(i.uniform1iv(this.addr,r),ke(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Kl(Zm):o=Ym;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Xb(i,t,e){let n=this.cache,s=t.length,r=Jl(e,s);ze(n,r)||(i.uniform1iv(this.addr,r),ke(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||jm,r[o])}function $b(i,t,e){let n=this.cache,s=t.length,r=Jl(e,s);ze(n,r)||(i.uniform1iv(this.addr,r),ke(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Kl(Jm):o=Qm;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function Yb(i,t,e){let n=this.cache,s=t.length,r=Jl(e,s);ze(n,r)||(i.uniform1iv(this.addr,r),ke(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Km,r[o])}function Zb(i){switch(i){case 5126:return Ib;case 35664:return Pb;case 35665:return Lb;case 35666:return Nb;case 35674:return Db;case 35675:return Ub;case 35676:return Ob;case 5124:case 35670:return Fb;case 35667:case 35671:return Bb;case 35668:case 35672:return zb;case 35669:case 35673:return kb;case 5125:return Gb;case 36294:return Vb;case 36295:return Hb;case 36296:return Wb;case 35678:case 36198:case 36298:case 36306:case 35682:return qb;case 35679:case 36299:case 36307:return Xb;case 35680:case 36300:case 36308:case 36293:return $b;case 36289:case 36303:case 36311:case 36292:return Yb}}var vd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Cb(e.type)}},Md=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Zb(e.type)}},Sd=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},_d=/(\w+)(\])?(\[|\.)?/g;function Lm(i,t){i.seq.push(t),i.map[t.id]=t}function Jb(i,t,e){let n=i.name,s=n.length;for(_d.lastIndex=0;;){let r=_d.exec(n),o=_d.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){Lm(e,l===void 0?new vd(a,i,t):new Md(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new Sd(a),Lm(e,u)),e=u}}}var qr=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);Jb(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function Nm(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var Kb=37297,jb=0;function Qb(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Dm=new Ft;function t1(i){jt._getMatrix(Dm,jt.workingColorSpace,i);let t=`mat3( ${Dm.elements.map(e=>e.toFixed(4))} )`;switch(jt.getTransfer(i)){case Lo:return[t,"LinearTransferOETF"];case oe:return[t,"sRGBTransferOETF"];default:return Pt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Um(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Qb(i.getShaderSource(t),a)}else return r}function e1(i,t){let e=t1(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var n1={[qu]:"Linear",[Xu]:"Reinhard",[$u]:"Cineon",[Yu]:"ACESFilmic",[Ju]:"AgX",[Ku]:"Neutral",[Zu]:"Custom"};function i1(i,t){let e=n1[t];return e===void 0?(Pt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var $l=new C;function s1(){jt.getLuminanceCoefficients($l);let i=$l.x.toFixed(4),t=$l.y.toFixed(4),e=$l.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function r1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ga).join(`
`)}function o1(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function a1(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function ga(i){return i!==""}function Om(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Fm(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var c1=/^[ \t]*#include +<([\w\d./]+)>/gm;function bd(i){return i.replace(c1,l1)}function l1(i,t){let e=$t[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return bd(e)}var h1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Bm(i){return i.replace(h1,u1)}function u1(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function zm(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var d1={[ra]:"SHADOWMAP_TYPE_PCF",[kr]:"SHADOWMAP_TYPE_VSM"};function f1(i){return d1[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var p1={[Vr]:"ENVMAP_MODE_REFRACTION"};function m1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":p1[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var g1={[oa]:"ENVMAP_BLENDING_MULTIPLY",[rm]:"ENVMAP_BLENDING_MIX",[om]:"ENVMAP_BLENDING_ADD"};function x1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":g1[i.combine]||"ENVMAP_BLENDING_NONE"}function _1(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=f1(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=m1(e),u=x1(e),d=r1(e),f=o1(r),p=s.createProgram(),g,m,x=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(ga).join(`
`),g.length>0&&(g+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(ga).join(`
`),m.length>0&&(m+=`
`)):(g=[zm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ga).join(`
`),m=[zm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==bi?"#define TONE_MAPPING":"",e.toneMapping!==bi?$t.tonemapping_pars_fragment:"",e.toneMapping!==bi?i1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",$t.colorspace_pars_fragment,e1("linearToOutputTexel",e.outputColorSpace),s1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(ga).join(`
`)),o=bd(o),o=Om(o,e),o=Fm(o,e),a=bd(a),a=Om(a,e),a=Fm(a,e),o=Bm(o),a=Bm(a),e.isRawShaderMaterial!==!0&&(x=`#version 300 es
`,g=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,m=["#define varying in",e.glslVersion===ld?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===ld?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=x+g+o,M=x+m+a,v=Nm(s,s.VERTEX_SHADER,_),b=Nm(s,s.FRAGMENT_SHADER,M);s.attachShader(p,v),s.attachShader(p,b),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function w(T){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",N=s.getShaderInfoLog(v)||"",F=s.getShaderInfoLog(b)||"",P=L.trim(),B=N.trim(),G=F.trim(),H=!0,j=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,v,b);else{let W=Um(s,v,"vertex"),Y=Um(s,b,"fragment");Ut("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+P+`
`+W+`
`+Y)}else P!==""?Pt("WebGLProgram: Program Info Log:",P):(B===""||G==="")&&(j=!1);j&&(T.diagnostics={runnable:H,programLog:P,vertexShader:{log:B,prefix:g},fragmentShader:{log:G,prefix:m}})}s.deleteShader(v),s.deleteShader(b),y=new qr(s,p),S=a1(s,p)}let y;this.getUniforms=function(){return y===void 0&&w(this),y};let S;this.getAttributes=function(){return S===void 0&&w(this),S};let I=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(p,Kb)),I},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=jb++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=b,this}var y1=0,wd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Ad(t),e.set(t,n)),n}},Ad=class{constructor(t){this.id=y1++,this.code=t,this.usedTimes=0}};function v1(i){return i===Ms||i===da||i===fa}function M1(i,t,e,n,s,r){let o=new Oo,a=new wd,c=new Set,l=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return c.add(y),y===0?"uv":`uv${y}`}function p(y,S,I,T,L,N){let F=T.fog,P=L.geometry,B=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?T.environment:null,G=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=t.get(y.envMap||B,G),j=d[y.type],W=n.precision;y.precision!==null&&(W=n.getMaxPrecision(y.precision),W!==y.precision&&Pt("WebGLProgram.getParameters:",y.precision,"not supported, using",W,"instead."));let Y=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,tt=Y!==void 0?Y.length:0,gt=0;P.morphAttributes.position!==void 0&&(gt=1),P.morphAttributes.normal!==void 0&&(gt=2),P.morphAttributes.color!==void 0&&(gt=3);let wt,X,rt,xt;if(j){let _t=_n[j];wt=_t.vertexShader,X=_t.fragmentShader}else{wt=y.vertexShader,X=y.fragmentShader;let _t=a.getVertexShaderStage(y),le=a.getFragmentShaderStage(y);a.update(y,_t,le),rt=_t.id,xt=le.id}let At=i.getRenderTarget(),pt=i.state.buffers.depth.getReversed(),Dt=L.isInstancedMesh===!0,me=L.isBatchedMesh===!0,Rt=!!y.map,Zt=!!y.matcap,te=!!H,Vt=te&&H.isPMREMTexture===!0,Te=!!y.aoMap,Me=!!y.lightMap,se=!!y.bumpMap&&y.wireframe===!1,ge=!!y.normalMap,Cn=!!y.displacementMap,Le=!!y.emissiveMap,un=!!y.metalnessMap,Gn=!!y.roughnessMap,Vn=y.anisotropy>0,O=y.clearcoat>0,Hn=y.diffuseRoughness>0,be=y.dispersion>0,we=y.retroreflectivity>0,mt=y.iridescence>0,Fe=y.sheen>0,Lt=y.transmission>0,Bt=Vn&&!!y.anisotropyMap,R=O&&!!y.clearcoatMap,A=O&&!!y.clearcoatNormalMap,k=O&&!!y.clearcoatRoughnessMap,et=Hn&&!!y.diffuseRoughnessMap,Q=mt&&!!y.iridescenceMap,ot=mt&&!!y.iridescenceThicknessMap,ut=Fe&&!!y.sheenColorMap,Z=Fe&&!!y.sheenRoughnessMap,J=!!y.specularMap,ct=!!y.specularColorMap,D=!!y.specularIntensityMap,K=Lt&&!!y.transmissionMap,$=Lt&&!!y.thicknessMap,lt=!!y.gradientMap,it=!!y.alphaMap,at=y.alphaTest>0,Ct=!!y.alphaHash,Xt=!!y.extensions,nt=bi;y.toneMapped&&(At===null||At.isXRRenderTarget===!0)&&(nt=i.toneMapping);let It=Vt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,qt={shaderID:j,shaderType:y.type,shaderName:y.name,vertexShader:wt,fragmentShader:X,defines:y.defines,customVertexShaderID:rt,customFragmentShaderID:xt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:W,batching:me,batchingColor:me&&L._colorsTexture!==null,instancing:Dt,instancingColor:Dt&&L.instanceColor!==null,instancingMorph:Dt&&L.morphTexture!==null,outputColorSpace:At===null?i.outputColorSpace:At.isXRRenderTarget===!0?At.texture.colorSpace:jt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Rt,matcap:Zt,envMap:te,envMapMode:te&&H.mapping,envMapPMREM:Vt,envMapMaxLod:Vt?It.length-1:null,envMapSize:Vt?It[0].width:null,aoMap:Te,lightMap:Me,bumpMap:se,normalMap:ge,displacementMap:Cn,emissiveMap:Le,normalMapObjectSpace:ge&&y.normalMapType===lm,normalMapTangentSpace:ge&&y.normalMapType===Wr,packedNormalMap:ge&&y.normalMapType===Wr&&v1(y.normalMap.format),metalnessMap:un,roughnessMap:Gn,anisotropy:Vn,anisotropyMap:Bt,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:A,clearcoatRoughnessMap:k,diffuseRoughness:Hn,diffuseRoughnessMap:et,dispersion:be,retroreflection:we,iridescence:mt,iridescenceMap:Q,iridescenceThicknessMap:ot,sheen:Fe,sheenColorMap:ut,sheenRoughnessMap:Z,specularMap:J,specularColorMap:ct,specularIntensityMap:D,transmission:Lt,transmissionMap:K,thicknessMap:$,gradientMap:lt,opaque:y.transparent===!1&&y.blending===Gr&&y.alphaToCoverage===!1,alphaMap:it,alphaTest:at,alphaHash:Ct,combine:y.combine,mapUv:Rt&&f(y.map.channel),aoMapUv:Te&&f(y.aoMap.channel),lightMapUv:Me&&f(y.lightMap.channel),bumpMapUv:se&&f(y.bumpMap.channel),normalMapUv:ge&&f(y.normalMap.channel),displacementMapUv:Cn&&f(y.displacementMap.channel),emissiveMapUv:Le&&f(y.emissiveMap.channel),metalnessMapUv:un&&f(y.metalnessMap.channel),roughnessMapUv:Gn&&f(y.roughnessMap.channel),anisotropyMapUv:Bt&&f(y.anisotropyMap.channel),clearcoatMapUv:R&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:A&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:k&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:et&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:ot&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:ut&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:Z&&f(y.sheenRoughnessMap.channel),specularMapUv:J&&f(y.specularMap.channel),specularColorMapUv:ct&&f(y.specularColorMap.channel),specularIntensityMapUv:D&&f(y.specularIntensityMap.channel),transmissionMapUv:K&&f(y.transmissionMap.channel),thicknessMapUv:$&&f(y.thicknessMap.channel),alphaMapUv:it&&f(y.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(ge||Vn),vertexNormals:!!P.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!P.attributes.uv&&(Rt||it),fog:!!F,useFog:y.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||P.attributes.normal===void 0&&ge===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:pt,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:gt,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:N.filter(_t=>_t.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&I.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:Rt&&y.map.isVideoTexture===!0&&jt.getTransfer(y.map.colorSpace)===oe,decodeVideoTextureEmissive:Le&&y.emissiveMap.isVideoTexture===!0&&jt.getTransfer(y.emissiveMap.colorSpace)===oe,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Si,flipSided:y.side===xn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Xt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Xt&&y.extensions.multiDraw===!0||me)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return qt.vertexUv1s=c.has(1),qt.vertexUv2s=c.has(2),qt.vertexUv3s=c.has(3),c.clear(),qt}function g(y){let S=[];if(y.shaderID?S.push(y.shaderID):(S.push(y.customVertexShaderID),S.push(y.customFragmentShaderID)),y.defines!==void 0)for(let I in y.defines)S.push(I),S.push(y.defines[I]);return y.isRawShaderMaterial===!1&&(m(S,y),x(S,y),S.push(i.outputColorSpace)),S.push(y.customProgramCacheKey),S.join()}function m(y,S){y.push(S.precision),y.push(S.outputColorSpace),y.push(S.envMapMode),y.push(S.envMapPMREM),y.push(S.envMapMaxLod),y.push(S.envMapSize),y.push(S.mapUv),y.push(S.alphaMapUv),y.push(S.lightMapUv),y.push(S.aoMapUv),y.push(S.bumpMapUv),y.push(S.normalMapUv),y.push(S.displacementMapUv),y.push(S.emissiveMapUv),y.push(S.metalnessMapUv),y.push(S.roughnessMapUv),y.push(S.anisotropyMapUv),y.push(S.clearcoatMapUv),y.push(S.clearcoatNormalMapUv),y.push(S.clearcoatRoughnessMapUv),y.push(S.diffuseRoughnessMapUv),y.push(S.iridescenceMapUv),y.push(S.iridescenceThicknessMapUv),y.push(S.sheenColorMapUv),y.push(S.sheenRoughnessMapUv),y.push(S.specularMapUv),y.push(S.specularColorMapUv),y.push(S.specularIntensityMapUv),y.push(S.transmissionMapUv),y.push(S.thicknessMapUv),y.push(S.combine),y.push(S.fogExp2),y.push(S.sizeAttenuation),y.push(S.morphTargetsCount),y.push(S.numSunLights),y.push(S.numDirLights),y.push(S.numPointLights),y.push(S.numSpotLights),y.push(S.numSpotLightMaps),y.push(S.numHemiLights),y.push(S.numRectAreaLights),y.push(S.numSunLightShadows),y.push(S.numDirLightShadows),y.push(S.numPointLightShadows),y.push(S.numSpotLightShadows),y.push(S.numSpotLightShadowsWithMaps),y.push(S.numLightProbes),y.push(S.numLightProbeGrids),y.push(S.shadowMapType),y.push(S.toneMapping),y.push(S.numClippingPlanes),y.push(S.numClipIntersection),y.push(S.depthPacking)}function x(y,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let S=d[y.type],I;if(S){let T=_n[S];I=pa.clone(T.uniforms)}else I=y.uniforms;return I}function M(y,S){let I=h.get(S);return I!==void 0?++I.usedTimes:(I=new _1(i,S,y,s),l.push(I),h.set(S,I)),I}function v(y){if(--y.usedTimes===0){let S=l.indexOf(y);l[S]=l[l.length-1],l.pop(),h.delete(y.cacheKey),y.destroy()}}function b(y){a.remove(y)}function w(){a.dispose()}return{getParameters:p,getProgramCacheKey:g,getUniforms:_,acquireProgram:M,releaseProgram:v,releaseShaderCache:b,programs:l,dispose:w}}function S1(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function b1(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function km(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Gm(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,g,m,x){let _=i[t];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:g,renderOrder:d.renderOrder,z:m,group:x},i[t]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=g,_.renderOrder=d.renderOrder,_.z=m,_.group=x),t++,_}function c(d,f,p,g,m,x,_){_.reversedDepth===!0&&(m=-m);let M=a(d,f,p,g,m,x);p.transmission>0?n.push(M):p.transparent===!0?s.push(M):e.push(M)}function l(d,f,p,g,m,x){let _=a(d,f,p,g,m,x);p.transmission>0?n.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function h(d,f){e.length>1&&e.sort(d||b1),n.length>1&&n.sort(f||km),s.length>1&&s.sort(f||km)}function u(){for(let d=t,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:u,sort:h}}function w1(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new Gm,i.set(n,[o])):s>=r.length?(o=new Gm,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function A1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new C,color:new Ot};break;case"SpotLight":e={position:new C,direction:new C,color:new Ot,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new C,color:new Ot,distance:0,decay:0};break;case"HemisphereLight":e={direction:new C,skyColor:new Ot,groundColor:new Ot};break;case"RectAreaLight":e={color:new Ot,position:new C,halfWidth:new C,halfHeight:new C};break}return i[t.id]=e,e}}}function E1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Gt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Gt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Gt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var T1=0;function R1(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function C1(i){let t=new A1,e=E1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new C);let s=new C,r=new Qt,o=new Qt;function a(l){let h=0,u=0,d=0;for(let N=0;N<9;N++)n.probe[N].set(0,0,0);let f=0,p=0,g=0,m=0,x=0,_=0,M=0,v=0,b=0,w=0,y=0,S=0,I=0,T=0;l.sort(R1);for(let N=0,F=l.length;N<F;N++){let P=l[N],B=P.color,G=P.intensity,H=P.distance,j=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===Ms?j=P.shadow.map.texture:j=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=B.r*G,u+=B.g*G,d+=B.b*G;else if(P.isLightProbe){for(let W=0;W<9;W++)n.probe[W].addScaledVector(P.sh.coefficients[W],G);T++}else if(P.isSunLight){let W=t.get(P);if(W.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Y=P.shadow,tt=e.get(P);tt.shadowIntensity=Y.intensity,tt.shadowBias=Y.bias,tt.shadowNormalBias=Y.normalBias,tt.shadowRadius=Y.radius,tt.shadowMapSize.copy(Y.mapSize).multiply(Y.getFrameExtents()),n.sunShadow[p]=tt,n.sunShadowMap[p]=j;let gt=Y.getViewportCount();for(let wt=0;wt<gt;wt++)n.sunShadowMatrix[g+wt]=Y.getMatrix(wt),n.sunShadowCascade[g+wt]=Y._cascadeData[wt];g+=gt,p++}n.sun[f]=W,f++}else if(P.isDirectionalLight){let W=t.get(P);if(W.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Y=P.shadow,tt=e.get(P);tt.shadowIntensity=Y.intensity,tt.shadowBias=Y.bias,tt.shadowNormalBias=Y.normalBias,tt.shadowRadius=Y.radius,tt.shadowMapSize=Y.mapSize,n.directionalShadow[m]=tt,n.directionalShadowMap[m]=j,n.directionalShadowMatrix[m]=P.shadow.matrix,b++}n.directional[m]=W,m++}else if(P.isSpotLight){let W=t.get(P);W.position.setFromMatrixPosition(P.matrixWorld),W.color.copy(B).multiplyScalar(G),W.distance=H,W.coneCos=Math.cos(P.angle),W.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),W.decay=P.decay,n.spot[_]=W;let Y=P.shadow;if(P.map&&(n.spotLightMap[S]=P.map,S++,Y.updateMatrices(P),P.castShadow&&I++),n.spotLightMatrix[_]=Y.matrix,P.castShadow){let tt=e.get(P);tt.shadowIntensity=Y.intensity,tt.shadowBias=Y.bias,tt.shadowNormalBias=Y.normalBias,tt.shadowRadius=Y.radius,tt.shadowMapSize=Y.mapSize,n.spotShadow[_]=tt,n.spotShadowMap[_]=j,y++}_++}else if(P.isRectAreaLight){let W=t.get(P);W.color.copy(B).multiplyScalar(G),W.halfWidth.set(P.width*.5,0,0),W.halfHeight.set(0,P.height*.5,0),n.rectArea[M]=W,M++}else if(P.isPointLight){let W=t.get(P);if(W.color.copy(P.color).multiplyScalar(P.intensity),W.distance=P.distance,W.decay=P.decay,P.castShadow){let Y=P.shadow,tt=e.get(P);tt.shadowIntensity=Y.intensity,tt.shadowBias=Y.bias,tt.shadowNormalBias=Y.normalBias,tt.shadowRadius=Y.radius,tt.shadowMapSize=Y.mapSize,tt.shadowCameraNear=Y.camera.near,tt.shadowCameraFar=Y.camera.far,n.pointShadow[x]=tt,n.pointShadowMap[x]=j,n.pointShadowMatrix[x]=P.shadow.matrix,w++}n.point[x]=W,x++}else if(P.isHemisphereLight){let W=t.get(P);W.skyColor.copy(P.color).multiplyScalar(G),W.groundColor.copy(P.groundColor).multiplyScalar(G),n.hemi[v]=W,v++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let L=n.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==x||L.spotLength!==_||L.rectAreaLength!==M||L.hemiLength!==v||L.numSunShadows!==p||L.numDirectionalShadows!==b||L.numPointShadows!==w||L.numSpotShadows!==y||L.numSpotMaps!==S||L.numLightProbes!==T)&&(n.sun.length=f,n.directional.length=m,n.spot.length=_,n.rectArea.length=M,n.point.length=x,n.hemi.length=v,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=g,n.sunShadowCascade.length=g,n.directionalShadow.length=b,n.directionalShadowMap.length=b,n.directionalShadowMatrix.length=b,n.pointShadow.length=w,n.pointShadowMap.length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+S-I,n.spotLightMap.length=S,n.numSpotLightShadowsWithMaps=I,n.numLightProbes=T,L.sunLength=f,L.directionalLength=m,L.pointLength=x,L.spotLength=_,L.rectAreaLength=M,L.hemiLength=v,L.numSunShadows=p,L.numDirectionalShadows=b,L.numPointShadows=w,L.numSpotShadows=y,L.numSpotMaps=S,L.numLightProbes=T,n.version=T1++)}function c(l,h){let u=0,d=0,f=0,p=0,g=0,m=0,x=h.matrixWorldInverse;for(let _=0,M=l.length;_<M;_++){let v=l[_];if(v.isSunLight){let b=n.sun[u];b.direction.setFromMatrixPosition(v.matrixWorld),b.direction.transformDirection(x),u++}else if(v.isDirectionalLight){let b=n.directional[d];b.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(x),d++}else if(v.isSpotLight){let b=n.spot[p];b.position.setFromMatrixPosition(v.matrixWorld),b.position.applyMatrix4(x),b.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(x),p++}else if(v.isRectAreaLight){let b=n.rectArea[g];b.position.setFromMatrixPosition(v.matrixWorld),b.position.applyMatrix4(x),o.identity(),r.copy(v.matrixWorld),r.premultiply(x),o.extractRotation(r),b.halfWidth.set(v.width*.5,0,0),b.halfHeight.set(0,v.height*.5,0),b.halfWidth.applyMatrix4(o),b.halfHeight.applyMatrix4(o),g++}else if(v.isPointLight){let b=n.point[f];b.position.setFromMatrixPosition(v.matrixWorld),b.position.applyMatrix4(x),f++}else if(v.isHemisphereLight){let b=n.hemi[m];b.direction.setFromMatrixPosition(v.matrixWorld),b.direction.transformDirection(x),m++}}}return{setup:a,setupView:c,state:n}}function Vm(i){let t=new C1(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function c(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function l(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function I1(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Vm(i),t.set(s,[a])):r>=o.length?(a=new Vm(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var P1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,L1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,N1=[new C(1,0,0),new C(-1,0,0),new C(0,1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1)],D1=[new C(0,-1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1),new C(0,-1,0),new C(0,-1,0)],Hm=new Qt,ma=new C,yd=new C;function U1(i,t,e){let n=new fs,s=new Gt,r=new Gt,o=new ce,a=new Wc,c=new qc,l={},h=e.maxTextureSize,u={[vs]:xn,[xn]:vs,[Si]:Si},d=new Yn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Gt},radius:{value:4}},vertexShader:P1,fragmentShader:L1}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new _e;p.setAttribute("position",new Ce(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let g=new Yt(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ra;let x=this.type;this.render=function(w,y,S){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||w.length===0)return;this.type===kp&&(Pt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ra);let I=i.getRenderTarget(),T=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),N=i.state;N.setBlending(js),N.buffers.depth.getReversed()===!0?N.buffers.color.setClear(0,0,0,0):N.buffers.color.setClear(1,1,1,1),N.buffers.depth.setTest(!0),N.setScissorTest(!1);let F=x!==this.type;F&&y.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(B=>B.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,B=w.length;P<B;P++){let G=w[P],H=G.shadow;if(H===void 0){Pt("WebGLShadowMap:",G,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let j=H.getFrameExtents();s.multiply(j),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/j.x),s.x=r.x*j.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/j.y),s.y=r.y*j.y,H.mapSize.y=r.y));let W=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=W,H.map===null||F===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===kr){if(G.isPointLight){Pt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Nn(s.x,s.y,{format:Ms,type:ci,minFilter:Be,magFilter:Be,generateMipmaps:!1}),H.map.texture.name=G.name+".shadowMap",H.map.depthTexture=new Hi(s.x,s.y,Zn),H.map.depthTexture.name=G.name+".shadowMapDepth",H.map.depthTexture.format=Vi,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=$e,H.map.depthTexture.magFilter=$e}else G.isPointLight?(H.map=new xa(s.x),H.map.depthTexture=new Wo(s.x,ai)):(H.map=new Nn(s.x,s.y),H.map.depthTexture=new Hi(s.x,s.y,ai)),H.map.depthTexture.name=G.name+".shadowMap",H.map.depthTexture.format=Vi,this.type===ra?(H.map.depthTexture.compareFunction=W?od:rd,H.map.depthTexture.minFilter=Be,H.map.depthTexture.magFilter=Be):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=$e,H.map.depthTexture.magFilter=$e);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Y=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();G.isPointLight!==!0&&H.updateMatrices(G,S);let tt=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:S.layers;for(let gt=0;gt<Y;gt++){let wt=H.getCamera(gt);if(G.isPointLight){let X=H.camera,rt=H.matrix,xt=G.distance||X.far;xt!==X.far&&(X.far=xt,X.updateProjectionMatrix()),ma.setFromMatrixPosition(G.matrixWorld),X.position.copy(ma),yd.copy(X.position),yd.add(N1[gt]),X.up.copy(D1[gt]),X.lookAt(yd),X.updateMatrixWorld(),rt.makeTranslation(-ma.x,-ma.y,-ma.z),Hm.multiplyMatrices(X.projectionMatrix,X.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Hm,X.coordinateSystem,X.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,gt),i.clear();else{gt===0&&(i.setRenderTarget(H.map),i.clear());let X=H.getViewport(gt);o.set(r.x*X.x,r.y*X.y,r.x*X.z,r.y*X.w),N.viewport(o)}n=H.getFrustum(gt),v(y,S,wt,G,tt,this.type)}H.isPointLightShadow!==!0&&this.type===kr&&_(H,S),H.needsUpdate=!1}x=this.type,m.needsUpdate=!1,i.setRenderTarget(I,T,L)};function _(w,y){let S=t.update(g);d.defines.VSM_SAMPLES!==w.blurSamples&&(d.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new Nn(s.x,s.y,{format:Ms,type:ci}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),d.uniforms.shadow_pass.value=w.map.depthTexture,d.uniforms.resolution.value.set(w.map.width,w.map.height),d.uniforms.radius.value=w.radius,i.setRenderTarget(w.mapPass),i.clear(),i.renderBufferDirect(y,null,S,d,g,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,i.setRenderTarget(w.map),i.clear(),i.renderBufferDirect(y,null,S,f,g,null)}function M(w,y,S,I){let T=null,L=S.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(L!==void 0)T=L;else if(T=S.isPointLight===!0?c:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let N=T.uuid,F=y.uuid,P=l[N];P===void 0&&(P={},l[N]=P);let B=P[F];B===void 0&&(B=T.clone(),P[F]=B,y.addEventListener("dispose",b)),T=B}if(T.visible=y.visible,T.wireframe=y.wireframe,I===kr?T.side=y.shadowSide!==null?y.shadowSide:y.side:T.side=y.shadowSide!==null?y.shadowSide:u[y.side],T.alphaMap=y.alphaMap,T.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,T.map=y.map,T.clipShadows=y.clipShadows,T.clippingPlanes=y.clippingPlanes,T.clipIntersection=y.clipIntersection,T.displacementMap=y.displacementMap,T.displacementScale=y.displacementScale,T.displacementBias=y.displacementBias,T.wireframeLinewidth=y.wireframeLinewidth,T.linewidth=y.linewidth,S.isPointLight===!0&&T.isMeshDistanceMaterial===!0){let N=i.properties.get(T);N.light=S}return T}function v(w,y,S,I,T,L){if(w.visible===!1)return;if(w.layers.test(T)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&L===kr)&&(!w.frustumCulled||w.intersectsFrustum(n))){w.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,w.matrixWorld);let P=t.update(w),B=w.material;if(Array.isArray(B)){let G=P.groups;for(let H=0,j=G.length;H<j;H++){let W=G[H],Y=B[W.materialIndex];if(Y&&Y.visible){let tt=M(w,Y,I,L);w.onBeforeShadow(i,w,y,S,P,tt,W),i.renderBufferDirect(S,null,P,tt,w,W),w.onAfterShadow(i,w,y,S,P,tt,W)}}}else if(B.visible){let G=M(w,B,I,L);w.onBeforeShadow(i,w,y,S,P,G,null),i.renderBufferDirect(S,null,P,G,w,null),w.onAfterShadow(i,w,y,S,P,G,null)}}let F=w.children;for(let P=0,B=F.length;P<B;P++)v(F[P],y,S,I,T,L)}function b(w){w.target.removeEventListener("dispose",b);for(let S in l){let I=l[S],T=w.target.uuid;T in I&&(I[T].dispose(),delete I[T])}}}function O1(i,t){function e(){let D=!1,K=new ce,$=null,lt=new ce(0,0,0,0);return{setMask:function(it){$!==it&&!D&&(i.colorMask(it,it,it,it),$=it)},setLocked:function(it){D=it},setClear:function(it,at,Ct,Xt,nt){nt===!0&&(it*=Xt,at*=Xt,Ct*=Xt),K.set(it,at,Ct,Xt),lt.equals(K)===!1&&(i.clearColor(it,at,Ct,Xt),lt.copy(K))},reset:function(){D=!1,$=null,lt.set(-1,0,0,0)}}}function n(){let D=!1,K=!1,$=null,lt=null,it=null;return{setReversed:function(at){if(K!==at){let Ct=t.get("EXT_clip_control");at?Ct.clipControlEXT(Ct.LOWER_LEFT_EXT,Ct.ZERO_TO_ONE_EXT):Ct.clipControlEXT(Ct.LOWER_LEFT_EXT,Ct.NEGATIVE_ONE_TO_ONE_EXT),K=at;let Xt=it;it=null,this.setClear(Xt)}},getReversed:function(){return K},setTest:function(at){at?pt(i.DEPTH_TEST):Dt(i.DEPTH_TEST)},setMask:function(at){$!==at&&!D&&(i.depthMask(at),$=at)},setFunc:function(at){if(K&&(at=ym[at]),lt!==at){switch(at){case Ec:i.depthFunc(i.NEVER);break;case Tc:i.depthFunc(i.ALWAYS);break;case Rc:i.depthFunc(i.LESS);break;case Rr:i.depthFunc(i.LEQUAL);break;case Cc:i.depthFunc(i.EQUAL);break;case Ic:i.depthFunc(i.GEQUAL);break;case Pc:i.depthFunc(i.GREATER);break;case Lc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}lt=at}},setLocked:function(at){D=at},setClear:function(at){it!==at&&(it=at,K&&(at=1-at),i.clearDepth(at))},reset:function(){D=!1,$=null,lt=null,it=null,K=!1}}}function s(){let D=!1,K=null,$=null,lt=null,it=null,at=null,Ct=null,Xt=null,nt=null;return{setTest:function(It){D||(It?pt(i.STENCIL_TEST):Dt(i.STENCIL_TEST))},setMask:function(It){K!==It&&!D&&(i.stencilMask(It),K=It)},setFunc:function(It,qt,_t){($!==It||lt!==qt||it!==_t)&&(i.stencilFunc(It,qt,_t),$=It,lt=qt,it=_t)},setOp:function(It,qt,_t){(at!==It||Ct!==qt||Xt!==_t)&&(i.stencilOp(It,qt,_t),at=It,Ct=qt,Xt=_t)},setLocked:function(It){D=It},setClear:function(It){nt!==It&&(i.clearStencil(It),nt=It)},reset:function(){D=!1,K=null,$=null,lt=null,it=null,at=null,Ct=null,Xt=null,nt=null}}}let r=new e,o=new n,a=new s,c={},l=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],g=null,m=!1,x=null,_=null,M=null,v=null,b=null,w=null,y=null,S=new Ot(0,0,0),I=0,T=!1,L=null,N=null,F=null,P=null,B=null,G=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,j=0,W=i.getParameter(i.VERSION);W.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(W)[1]),H=j>=1):W.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(W)[1]),H=j>=2);let Y=null,tt={},gt=i.getParameter(i.SCISSOR_BOX),wt=i.getParameter(i.VIEWPORT),X=new ce().fromArray(gt),rt=new ce().fromArray(wt);function xt(D,K,$,lt){let it=new Uint8Array(4),at=i.createTexture();i.bindTexture(D,at),i.texParameteri(D,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(D,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ct=0;Ct<$;Ct++)D===i.TEXTURE_3D||D===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,lt,0,i.RGBA,i.UNSIGNED_BYTE,it):i.texImage2D(K+Ct,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,it);return at}let At={};At[i.TEXTURE_2D]=xt(i.TEXTURE_2D,i.TEXTURE_2D,1),At[i.TEXTURE_CUBE_MAP]=xt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),At[i.TEXTURE_2D_ARRAY]=xt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),At[i.TEXTURE_3D]=xt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),pt(i.DEPTH_TEST),o.setFunc(Rr),se(!1),ge(zu),pt(i.CULL_FACE),Te(js);function pt(D){h[D]!==!0&&(i.enable(D),h[D]=!0)}function Dt(D){h[D]!==!1&&(i.disable(D),h[D]=!1)}function me(D,K){return d[D]!==K?(i.bindFramebuffer(D,K),d[D]=K,D===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),D===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Rt(D,K){let $=p,lt=!1;if(D){$=f.get(K),$===void 0&&($=[],f.set(K,$));let it=D.textures;if($.length!==it.length||$[0]!==i.COLOR_ATTACHMENT0){for(let at=0,Ct=it.length;at<Ct;at++)$[at]=i.COLOR_ATTACHMENT0+at;$.length=it.length,lt=!0}}else $[0]!==i.BACK&&($[0]=i.BACK,lt=!0);lt&&i.drawBuffers($)}function Zt(D){return g!==D?(i.useProgram(D),g=D,!0):!1}let te={[Qs]:i.FUNC_ADD,[Vp]:i.FUNC_SUBTRACT,[Hp]:i.FUNC_REVERSE_SUBTRACT};te[Wp]=i.MIN,te[qp]=i.MAX;let Vt={[Xp]:i.ZERO,[$p]:i.ONE,[Yp]:i.SRC_COLOR,[Hu]:i.SRC_ALPHA,[tm]:i.SRC_ALPHA_SATURATE,[jp]:i.DST_COLOR,[Jp]:i.DST_ALPHA,[Zp]:i.ONE_MINUS_SRC_COLOR,[Wu]:i.ONE_MINUS_SRC_ALPHA,[Qp]:i.ONE_MINUS_DST_COLOR,[Kp]:i.ONE_MINUS_DST_ALPHA,[em]:i.CONSTANT_COLOR,[nm]:i.ONE_MINUS_CONSTANT_COLOR,[im]:i.CONSTANT_ALPHA,[sm]:i.ONE_MINUS_CONSTANT_ALPHA};function Te(D,K,$,lt,it,at,Ct,Xt,nt,It){if(D===js){m===!0&&(Dt(i.BLEND),m=!1);return}if(m===!1&&(pt(i.BLEND),m=!0),D!==Gp){if(D!==x||It!==T){if((_!==Qs||b!==Qs)&&(i.blendEquation(i.FUNC_ADD),_=Qs,b=Qs),It)switch(D){case Gr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ku:i.blendFunc(i.ONE,i.ONE);break;case Gu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Vu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ut("WebGLState: Invalid blending: ",D);break}else switch(D){case Gr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ku:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Gu:Ut("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Vu:Ut("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ut("WebGLState: Invalid blending: ",D);break}M=null,v=null,w=null,y=null,S.set(0,0,0),I=0,x=D,T=It}return}it=it||K,at=at||$,Ct=Ct||lt,(K!==_||it!==b)&&(i.blendEquationSeparate(te[K],te[it]),_=K,b=it),($!==M||lt!==v||at!==w||Ct!==y)&&(i.blendFuncSeparate(Vt[$],Vt[lt],Vt[at],Vt[Ct]),M=$,v=lt,w=at,y=Ct),(Xt.equals(S)===!1||nt!==I)&&(i.blendColor(Xt.r,Xt.g,Xt.b,nt),S.copy(Xt),I=nt),x=D,T=!1}function Me(D,K){D.side===Si?Dt(i.CULL_FACE):pt(i.CULL_FACE);let $=D.side===xn;K&&($=!$),se($),D.blending===Gr&&D.transparent===!1?Te(js):Te(D.blending,D.blendEquation,D.blendSrc,D.blendDst,D.blendEquationAlpha,D.blendSrcAlpha,D.blendDstAlpha,D.blendColor,D.blendAlpha,D.premultipliedAlpha),o.setFunc(D.depthFunc),o.setTest(D.depthTest),o.setMask(D.depthWrite),r.setMask(D.colorWrite);let lt=D.stencilWrite;a.setTest(lt),lt&&(a.setMask(D.stencilWriteMask),a.setFunc(D.stencilFunc,D.stencilRef,D.stencilFuncMask),a.setOp(D.stencilFail,D.stencilZFail,D.stencilZPass)),Le(D.polygonOffset,D.polygonOffsetFactor,D.polygonOffsetUnits),D.alphaToCoverage===!0?pt(i.SAMPLE_ALPHA_TO_COVERAGE):Dt(i.SAMPLE_ALPHA_TO_COVERAGE)}function se(D){L!==D&&(D?i.frontFace(i.CW):i.frontFace(i.CCW),L=D)}function ge(D){D!==Bp?(pt(i.CULL_FACE),D!==N&&(D===zu?i.cullFace(i.BACK):D===zp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Dt(i.CULL_FACE),N=D}function Cn(D){D!==F&&(H&&i.lineWidth(D),F=D)}function Le(D,K,$){D?(pt(i.POLYGON_OFFSET_FILL),(P!==K||B!==$)&&(P=K,B=$,o.getReversed()&&(K=-K,$=-$),i.polygonOffset(K,$))):Dt(i.POLYGON_OFFSET_FILL)}function un(D){D?pt(i.SCISSOR_TEST):Dt(i.SCISSOR_TEST)}function Gn(D){D===void 0&&(D=i.TEXTURE0+G-1),Y!==D&&(i.activeTexture(D),Y=D)}function Vn(D,K,$){$===void 0&&(Y===null?$=i.TEXTURE0+G-1:$=Y);let lt=tt[$];lt===void 0&&(lt={type:void 0,texture:void 0},tt[$]=lt),(lt.type!==D||lt.texture!==K)&&(Y!==$&&(i.activeTexture($),Y=$),i.bindTexture(D,K||At[D]),lt.type=D,lt.texture=K)}function O(){let D=tt[Y];D!==void 0&&D.type!==void 0&&(i.bindTexture(D.type,null),D.type=void 0,D.texture=void 0)}function Hn(){try{i.compressedTexImage2D(...arguments)}catch(D){Ut("WebGLState:",D)}}function be(){try{i.compressedTexImage3D(...arguments)}catch(D){Ut("WebGLState:",D)}}function we(){try{i.texSubImage2D(...arguments)}catch(D){Ut("WebGLState:",D)}}function mt(){try{i.texSubImage3D(...arguments)}catch(D){Ut("WebGLState:",D)}}function Fe(){try{i.compressedTexSubImage2D(...arguments)}catch(D){Ut("WebGLState:",D)}}function Lt(){try{i.compressedTexSubImage3D(...arguments)}catch(D){Ut("WebGLState:",D)}}function Bt(){try{i.texStorage2D(...arguments)}catch(D){Ut("WebGLState:",D)}}function R(){try{i.texStorage3D(...arguments)}catch(D){Ut("WebGLState:",D)}}function A(){try{i.texImage2D(...arguments)}catch(D){Ut("WebGLState:",D)}}function k(){try{i.texImage3D(...arguments)}catch(D){Ut("WebGLState:",D)}}function et(D){return u[D]!==void 0?u[D]:i.getParameter(D)}function Q(D,K){u[D]!==K&&(i.pixelStorei(D,K),u[D]=K)}function ot(D){X.equals(D)===!1&&(i.scissor(D.x,D.y,D.z,D.w),X.copy(D))}function ut(D){rt.equals(D)===!1&&(i.viewport(D.x,D.y,D.z,D.w),rt.copy(D))}function Z(D,K){let $=l.get(K);$===void 0&&($=new WeakMap,l.set(K,$));let lt=$.get(D);lt===void 0&&(lt=i.getUniformBlockIndex(K,D.name),i.uniformBlockBinding(K,lt,lt),$.set(D,lt))}function J(D,K,$){let it=l.get(K).get(D);c[it]!==$&&(i.bindBufferBase(i.UNIFORM_BUFFER,it,$),c[it]=$)}function ct(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Y=null,tt={},d={},c={},f=new WeakMap,p=[],g=null,m=!1,x=null,_=null,M=null,v=null,b=null,w=null,y=null,S=new Ot(0,0,0),I=0,T=!1,L=null,N=null,F=null,P=null,B=null,X.set(0,0,i.canvas.width,i.canvas.height),rt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:pt,disable:Dt,bindFramebuffer:me,drawBuffers:Rt,useProgram:Zt,setBlending:Te,setMaterial:Me,setFlipSided:se,setCullFace:ge,setLineWidth:Cn,setPolygonOffset:Le,setScissorTest:un,activeTexture:Gn,bindTexture:Vn,unbindTexture:O,compressedTexImage2D:Hn,compressedTexImage3D:be,texImage2D:A,texImage3D:k,pixelStorei:Q,getParameter:et,updateUBOMapping:Z,uniformBlockBinding:J,texStorage2D:Bt,texStorage3D:R,texSubImage2D:we,texSubImage3D:mt,compressedTexSubImage2D:Fe,compressedTexSubImage3D:Lt,scissor:ot,viewport:ut,reset:ct}}function F1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Gt,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,g=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function x(R,A){return m?new OffscreenCanvas(R,A):No("canvas")}function _(R,A,k){let et=1,Q=Bt(R);if((Q.width>k||Q.height>k)&&(et=k/Math.max(Q.width,Q.height)),et<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ot=Math.floor(et*Q.width),ut=Math.floor(et*Q.height);d===void 0&&(d=x(ot,ut));let Z=A?x(ot,ut):d;return Z.width=ot,Z.height=ut,Z.getContext("2d").drawImage(R,0,0,ot,ut),Pt("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+ot+"x"+ut+")."),Z}else return"data"in R&&Pt("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),R;return R}function M(R){return R.generateMipmaps}function v(R){i.generateMipmap(R)}function b(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(R,A,k,et,Q,ot=!1){if(R!==null){if(i[R]!==void 0)return i[R];Pt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ut;et&&(ut=t.get("EXT_texture_norm16"),ut||Pt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=A;if(A===i.RED&&(k===i.FLOAT&&(Z=i.R32F),k===i.HALF_FLOAT&&(Z=i.R16F),k===i.UNSIGNED_BYTE&&(Z=i.R8),k===i.UNSIGNED_SHORT&&ut&&(Z=ut.R16_EXT),k===i.SHORT&&ut&&(Z=ut.R16_SNORM_EXT)),A===i.RED_INTEGER&&(k===i.UNSIGNED_BYTE&&(Z=i.R8UI),k===i.UNSIGNED_SHORT&&(Z=i.R16UI),k===i.UNSIGNED_INT&&(Z=i.R32UI),k===i.BYTE&&(Z=i.R8I),k===i.SHORT&&(Z=i.R16I),k===i.INT&&(Z=i.R32I)),A===i.RG&&(k===i.FLOAT&&(Z=i.RG32F),k===i.HALF_FLOAT&&(Z=i.RG16F),k===i.UNSIGNED_BYTE&&(Z=i.RG8),k===i.UNSIGNED_SHORT&&ut&&(Z=ut.RG16_EXT),k===i.SHORT&&ut&&(Z=ut.RG16_SNORM_EXT)),A===i.RG_INTEGER&&(k===i.UNSIGNED_BYTE&&(Z=i.RG8UI),k===i.UNSIGNED_SHORT&&(Z=i.RG16UI),k===i.UNSIGNED_INT&&(Z=i.RG32UI),k===i.BYTE&&(Z=i.RG8I),k===i.SHORT&&(Z=i.RG16I),k===i.INT&&(Z=i.RG32I)),A===i.RGB_INTEGER&&(k===i.UNSIGNED_BYTE&&(Z=i.RGB8UI),k===i.UNSIGNED_SHORT&&(Z=i.RGB16UI),k===i.UNSIGNED_INT&&(Z=i.RGB32UI),k===i.BYTE&&(Z=i.RGB8I),k===i.SHORT&&(Z=i.RGB16I),k===i.INT&&(Z=i.RGB32I)),A===i.RGBA_INTEGER&&(k===i.UNSIGNED_BYTE&&(Z=i.RGBA8UI),k===i.UNSIGNED_SHORT&&(Z=i.RGBA16UI),k===i.UNSIGNED_INT&&(Z=i.RGBA32UI),k===i.BYTE&&(Z=i.RGBA8I),k===i.SHORT&&(Z=i.RGBA16I),k===i.INT&&(Z=i.RGBA32I)),A===i.RGB&&(k===i.UNSIGNED_SHORT&&ut&&(Z=ut.RGB16_EXT),k===i.SHORT&&ut&&(Z=ut.RGB16_SNORM_EXT),k===i.UNSIGNED_INT_5_9_9_9_REV&&(Z=i.RGB9_E5),k===i.UNSIGNED_INT_10F_11F_11F_REV&&(Z=i.R11F_G11F_B10F)),A===i.RGBA){let J=ot?Lo:jt.getTransfer(Q);k===i.FLOAT&&(Z=i.RGBA32F),k===i.HALF_FLOAT&&(Z=i.RGBA16F),k===i.UNSIGNED_BYTE&&(Z=J===oe?i.SRGB8_ALPHA8:i.RGBA8),k===i.UNSIGNED_SHORT&&ut&&(Z=ut.RGBA16_EXT),k===i.SHORT&&ut&&(Z=ut.RGBA16_SNORM_EXT),k===i.UNSIGNED_SHORT_4_4_4_4&&(Z=i.RGBA4),k===i.UNSIGNED_SHORT_5_5_5_1&&(Z=i.RGB5_A1)}return(Z===i.R16F||Z===i.R32F||Z===i.RG16F||Z===i.RG32F||Z===i.RGBA16F||Z===i.RGBA32F)&&t.get("EXT_color_buffer_float"),Z}function y(R,A){let k;return R?A===null||A===ai||A===er?k=i.DEPTH24_STENCIL8:A===Zn?k=i.DEPTH32F_STENCIL8:A===Hr&&(k=i.DEPTH24_STENCIL8,Pt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):A===null||A===ai||A===er?k=i.DEPTH_COMPONENT24:A===Zn?k=i.DEPTH_COMPONENT32F:A===Hr&&(k=i.DEPTH_COMPONENT16),k}function S(R,A){return M(R)===!0||R.isFramebufferTexture&&R.minFilter!==$e&&R.minFilter!==Be?Math.log2(Math.max(A.width,A.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?A.mipmaps.length:1}function I(R){let A=new WeakRef(R);n.get(R).__ref=A,p.add(A),g.register(R,A,A)}function T(R){let A=n.get(R).__ref;A!==void 0&&(p.delete(A),g.unregister(A))}function L(R){F(R.target)}function N(R){P(R.target)}function F(R){R.removeEventListener("dispose",L),T(R),G(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function P(R){R.removeEventListener("dispose",N),T(R),j(R)}function B(){for(let R of p){let A=R.deref();A!==void 0&&(A.isRenderTarget===!0?P(A):F(A))}p.clear(),u.clear()}function G(R){let A=n.get(R);if(A.__webglInit===void 0)return;let k=R.source,et=f.get(k);if(et){let Q=et[A.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&H(R),Object.keys(et).length===0&&f.delete(k)}n.remove(R)}function H(R){let A=n.get(R);i.deleteTexture(A.__webglTexture);let k=R.source,et=f.get(k);delete et[A.__cacheKey],o.memory.textures--}function j(R){let A=n.get(R);A.__depthDisposeCallback&&A.__depthDisposeCallback();let k=R.depthTexture;if(k&&k.renderTarget===R&&F(k),R.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(A.__webglFramebuffer[Q]))for(let ot=0;ot<A.__webglFramebuffer[Q].length;ot++)i.deleteFramebuffer(A.__webglFramebuffer[Q][ot]);else i.deleteFramebuffer(A.__webglFramebuffer[Q]);A.__webglDepthbuffer&&i.deleteRenderbuffer(A.__webglDepthbuffer[Q])}else{if(Array.isArray(A.__webglFramebuffer))for(let Q=0;Q<A.__webglFramebuffer.length;Q++)i.deleteFramebuffer(A.__webglFramebuffer[Q]);else i.deleteFramebuffer(A.__webglFramebuffer);if(A.__webglDepthbuffer&&i.deleteRenderbuffer(A.__webglDepthbuffer),A.__webglMultisampledFramebuffer&&i.deleteFramebuffer(A.__webglMultisampledFramebuffer),A.__webglColorRenderbuffer)for(let Q=0;Q<A.__webglColorRenderbuffer.length;Q++)A.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(A.__webglColorRenderbuffer[Q]);A.__webglDepthRenderbuffer&&i.deleteRenderbuffer(A.__webglDepthRenderbuffer)}let et=R.textures;for(let Q=0,ot=et.length;Q<ot;Q++){let ut=n.get(et[Q]);ut.__webglTexture&&(i.deleteTexture(ut.__webglTexture),o.memory.textures--),n.remove(et[Q])}n.remove(R)}let W=0;function Y(){W=0}function tt(){return W}function gt(R){W=R}function wt(){let R=W;return R>=s.maxTextures&&Pt("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),W+=1,R}function X(R){let A=[];return A.push(R.wrapS),A.push(R.wrapT),A.push(R.wrapR||0),A.push(R.magFilter),A.push(R.minFilter),A.push(R.anisotropy),A.push(R.internalFormat),A.push(R.format),A.push(R.type),A.push(R.generateMipmaps),A.push(R.mipmapsAutoUpdate),A.push(R.premultiplyAlpha),A.push(R.flipY),A.push(R.unpackAlignment),A.push(R.colorSpace),A.join()}function rt(R,A){let k=n.get(R);if(R.isVideoTexture&&Fe(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&k.__version!==R.version){let et=R.image;if(et===null)Pt("WebGLRenderer: Texture marked for update but no image data found.");else if(et.complete===!1)Pt("WebGLRenderer: Texture marked for update but image is incomplete");else{Me(k,R,A);return}}else R.isExternalTexture&&(k.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,k.__webglTexture,i.TEXTURE0+A)}function xt(R,A){let k=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&k.__version!==R.version){Me(k,R,A);return}else R.isExternalTexture&&(k.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,k.__webglTexture,i.TEXTURE0+A)}function At(R,A){let k=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&k.__version!==R.version){Me(k,R,A);return}e.bindTexture(i.TEXTURE_3D,k.__webglTexture,i.TEXTURE0+A)}function pt(R,A){let k=n.get(R);if(R.version>0&&k.__version!==R.version){se(k,R,A);return}e.bindTexture(i.TEXTURE_CUBE_MAP,k.__webglTexture,i.TEXTURE0+A)}let Dt={[Nc]:i.REPEAT,[yi]:i.CLAMP_TO_EDGE,[Dc]:i.MIRRORED_REPEAT},me={[$e]:i.NEAREST,[am]:i.NEAREST_MIPMAP_NEAREST,[aa]:i.NEAREST_MIPMAP_LINEAR,[Be]:i.LINEAR,[ol]:i.LINEAR_MIPMAP_NEAREST,[qi]:i.LINEAR_MIPMAP_LINEAR},Rt={[um]:i.NEVER,[ad]:i.ALWAYS,[dm]:i.LESS,[rd]:i.LEQUAL,[fm]:i.EQUAL,[od]:i.GEQUAL,[pm]:i.GREATER,[mm]:i.NOTEQUAL};function Zt(R,A){if(A.type===Zn&&t.has("OES_texture_float_linear")===!1&&(A.magFilter===Be||A.magFilter===ol||A.magFilter===aa||A.magFilter===qi||A.minFilter===Be||A.minFilter===ol||A.minFilter===aa||A.minFilter===qi)&&Pt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Dt[A.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Dt[A.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Dt[A.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,me[A.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,me[A.minFilter]),A.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Rt[A.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(A.magFilter===$e||A.minFilter!==aa&&A.minFilter!==qi||A.type===Zn&&t.has("OES_texture_float_linear")===!1)return;if(A.anisotropy>1||n.get(A).__currentAnisotropy){let k=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,k.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(A.anisotropy,s.getMaxAnisotropy())),n.get(A).__currentAnisotropy=A.anisotropy}}}function te(R,A){let k=!1;R.__webglInit===void 0&&(R.__webglInit=!0,A.addEventListener("dispose",L),I(A));let et=A.source,Q=f.get(et);Q===void 0&&(Q={},f.set(et,Q));let ot=X(A);if(ot!==R.__cacheKey){Q[ot]===void 0&&(Q[ot]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,k=!0),Q[ot].usedTimes++;let ut=Q[R.__cacheKey];ut!==void 0&&(Q[R.__cacheKey].usedTimes--,ut.usedTimes===0&&H(A)),R.__cacheKey=ot,R.__webglTexture=Q[ot].texture}return k}function Vt(R,A,k){return Math.floor(Math.floor(R/k)/A)}function Te(R,A,k,et){let ot=R.updateRanges;if(ot.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,A.width,A.height,k,et,A.data);else{ot.sort((D,K)=>D.start-K.start);let ut=0;for(let D=1;D<ot.length;D++){let K=ot[ut],$=ot[D],lt=K.start+K.count,it=Vt($.start,A.width,4),at=Vt(K.start,A.width,4);$.start<=lt+1&&it===at&&Vt($.start+$.count-1,A.width,4)===it?K.count=Math.max(K.count,$.start+$.count-K.start):(++ut,ot[ut]=$)}ot.length=ut+1;let Z=e.getParameter(i.UNPACK_ROW_LENGTH),J=e.getParameter(i.UNPACK_SKIP_PIXELS),ct=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,A.width);for(let D=0,K=ot.length;D<K;D++){let $=ot[D],lt=Math.floor($.start/4),it=Math.ceil($.count/4),at=lt%A.width,Ct=Math.floor(lt/A.width),Xt=it,nt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,at),e.pixelStorei(i.UNPACK_SKIP_ROWS,Ct),e.texSubImage2D(i.TEXTURE_2D,0,at,Ct,Xt,nt,k,et,A.data)}R.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,Z),e.pixelStorei(i.UNPACK_SKIP_PIXELS,J),e.pixelStorei(i.UNPACK_SKIP_ROWS,ct)}}function Me(R,A,k){let et=i.TEXTURE_2D;(A.isDataArrayTexture||A.isCompressedArrayTexture)&&(et=i.TEXTURE_2D_ARRAY),A.isData3DTexture&&(et=i.TEXTURE_3D);let Q=te(R,A),ot=A.source;e.bindTexture(et,R.__webglTexture,i.TEXTURE0+k);let ut=n.get(ot);if(ot.version!==ut.__version||Q===!0){if(e.activeTexture(i.TEXTURE0+k),(typeof ImageBitmap<"u"&&A.image instanceof ImageBitmap)===!1){let nt=jt.getPrimaries(jt.workingColorSpace),It=A.colorSpace===$i?null:jt.getPrimaries(A.colorSpace),qt=A.colorSpace===$i||nt===It?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,A.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,A.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,qt)}e.pixelStorei(i.UNPACK_ALIGNMENT,A.unpackAlignment);let J=_(A.image,!1,s.maxTextureSize);J=Lt(A,J);let ct=r.convert(A.format,A.colorSpace),D=r.convert(A.type),K=w(A.internalFormat,ct,D,A.normalized,A.colorSpace,A.isVideoTexture);Zt(et,A);let $,lt=A.mipmaps,it=A.isVideoTexture!==!0,at=ut.__version===void 0||Q===!0,Ct=ot.dataReady,Xt=S(A,J);if(A.isDepthTexture)K=y(A.format===Xi,A.type),at&&(it?e.texStorage2D(i.TEXTURE_2D,1,K,J.width,J.height):e.texImage2D(i.TEXTURE_2D,0,K,J.width,J.height,0,ct,D,null));else if(A.isDataTexture)if(lt.length>0){it&&at&&e.texStorage2D(i.TEXTURE_2D,Xt,K,lt[0].width,lt[0].height);for(let nt=0,It=lt.length;nt<It;nt++)$=lt[nt],it?Ct&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,$.width,$.height,ct,D,$.data):e.texImage2D(i.TEXTURE_2D,nt,K,$.width,$.height,0,ct,D,$.data);A.generateMipmaps=!1}else it?(at&&e.texStorage2D(i.TEXTURE_2D,Xt,K,J.width,J.height),Ct&&Te(A,J,ct,D)):e.texImage2D(i.TEXTURE_2D,0,K,J.width,J.height,0,ct,D,J.data);else if(A.isCompressedTexture)if(A.isCompressedArrayTexture){it&&at&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Xt,K,lt[0].width,lt[0].height,J.depth);for(let nt=0,It=lt.length;nt<It;nt++)if($=lt[nt],A.format!==li)if(ct!==null)if(it){if(Ct)if(A.layerUpdates.size>0){let qt=xd($.width,$.height,A.format,A.type);for(let _t of A.layerUpdates){let le=$.data.subarray(_t*qt/$.data.BYTES_PER_ELEMENT,(_t+1)*qt/$.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,_t,$.width,$.height,1,ct,le)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,$.width,$.height,J.depth,ct,$.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,K,$.width,$.height,J.depth,0,$.data,0,0);else Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else it?Ct&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,$.width,$.height,J.depth,ct,D,$.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,K,$.width,$.height,J.depth,0,ct,D,$.data);A.layerUpdates.size>0&&A.clearLayerUpdates()}else{it&&at&&e.texStorage2D(i.TEXTURE_2D,Xt,K,lt[0].width,lt[0].height);for(let nt=0,It=lt.length;nt<It;nt++)$=lt[nt],A.format!==li?ct!==null?it?Ct&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,$.width,$.height,ct,$.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,K,$.width,$.height,0,$.data):Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):it?Ct&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,$.width,$.height,ct,D,$.data):e.texImage2D(i.TEXTURE_2D,nt,K,$.width,$.height,0,ct,D,$.data)}else if(A.isDataArrayTexture)if(it){if(at&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Xt,K,J.width,J.height,J.depth),Ct)if(A.layerUpdates.size>0){let nt=xd(J.width,J.height,A.format,A.type);for(let It of A.layerUpdates){let qt=J.data.subarray(It*nt/J.data.BYTES_PER_ELEMENT,(It+1)*nt/J.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,It,J.width,J.height,1,ct,D,qt)}A.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,J.width,J.height,J.depth,ct,D,J.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,K,J.width,J.height,J.depth,0,ct,D,J.data);else if(A.isData3DTexture)it?(at&&e.texStorage3D(i.TEXTURE_3D,Xt,K,J.width,J.height,J.depth),Ct&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,J.width,J.height,J.depth,ct,D,J.data)):e.texImage3D(i.TEXTURE_3D,0,K,J.width,J.height,J.depth,0,ct,D,J.data);else if(A.isFramebufferTexture){if(at)if(it)e.texStorage2D(i.TEXTURE_2D,Xt,K,J.width,J.height);else{let nt=J.width,It=J.height;for(let qt=0;qt<Xt;qt++)e.texImage2D(i.TEXTURE_2D,qt,K,nt,It,0,ct,D,null),nt>>=1,It>>=1}}else if(A.isHTMLTexture){if("texElementImage2D"in i){let nt=i.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),J.parentNode!==nt){nt.appendChild(J),u.add(A),nt.onpaint=It=>{let qt=It.changedElements;for(let _t of u)qt.includes(_t.image)&&(_t.needsUpdate=!0)},nt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,J);else{let qt=i.RGBA,_t=i.RGBA,le=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,qt,_t,le,J)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(lt.length>0){if(it&&at){let nt=Bt(lt[0]);e.texStorage2D(i.TEXTURE_2D,Xt,K,nt.width,nt.height)}for(let nt=0,It=lt.length;nt<It;nt++)$=lt[nt],it?Ct&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,ct,D,$):e.texImage2D(i.TEXTURE_2D,nt,K,ct,D,$);A.generateMipmaps=!1}else if(it){if(at){let nt=Bt(J);e.texStorage2D(i.TEXTURE_2D,Xt,K,nt.width,nt.height)}Ct&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,ct,D,J)}else e.texImage2D(i.TEXTURE_2D,0,K,ct,D,J);M(A)&&A.mipmapsAutoUpdate===!0&&v(et),ut.__version=ot.version,A.onUpdate&&A.onUpdate(A)}R.__version=A.version}function se(R,A,k){if(A.image.length!==6)return;let et=te(R,A),Q=A.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+k);let ot=n.get(Q);if(Q.version!==ot.__version||et===!0){e.activeTexture(i.TEXTURE0+k);let ut=jt.getPrimaries(jt.workingColorSpace),Z=A.colorSpace===$i?null:jt.getPrimaries(A.colorSpace),J=A.colorSpace===$i||ut===Z?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,A.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,A.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,A.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,J);let ct=A.isCompressedTexture||A.image[0].isCompressedTexture,D=A.image[0]&&A.image[0].isDataTexture,K=[];for(let _t=0;_t<6;_t++)!ct&&!D?K[_t]=_(A.image[_t],!0,s.maxCubemapSize):K[_t]=D?A.image[_t].image:A.image[_t],K[_t]=Lt(A,K[_t]);let $=K[0],lt=r.convert(A.format,A.colorSpace),it=r.convert(A.type),at=w(A.internalFormat,lt,it,A.normalized,A.colorSpace),Ct=A.isVideoTexture!==!0,Xt=ot.__version===void 0||et===!0,nt=Q.dataReady,It=S(A,$);Zt(i.TEXTURE_CUBE_MAP,A);let qt;if(A.isDepthTexture){if(at=y(A.format===Xi,A.type),Xt)if(Ct)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,at,$.width,$.height);else for(let _t=0;_t<6;_t++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,at,$.width,$.height,0,lt,it,null)}else if(ct){Ct&&Xt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,It,at,$.width,$.height);for(let _t=0;_t<6;_t++){qt=K[_t].mipmaps;for(let le=0;le<qt.length;le++){let We=qt[le];A.format!==li?lt!==null?Ct?nt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le,0,0,We.width,We.height,lt,We.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le,at,We.width,We.height,0,We.data):Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ct?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le,0,0,We.width,We.height,lt,it,We.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le,at,We.width,We.height,0,lt,it,We.data)}}}else{if(qt=A.mipmaps,Ct&&Xt){qt.length>0&&It++;let _t=Bt(K[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,It,at,_t.width,_t.height)}for(let _t=0;_t<6;_t++)if(D){Ct?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,0,0,K[_t].width,K[_t].height,lt,it,K[_t].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,at,K[_t].width,K[_t].height,0,lt,it,K[_t].data);for(let le=0;le<qt.length;le++){let rs=qt[le].image[_t].image;Ct?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le+1,0,0,rs.width,rs.height,lt,it,rs.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le+1,at,rs.width,rs.height,0,lt,it,rs.data)}}else{Ct?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,0,0,lt,it,K[_t]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,at,lt,it,K[_t]);for(let le=0;le<qt.length;le++){let We=qt[le];Ct?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le+1,0,0,lt,it,We.image[_t]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le+1,at,lt,it,We.image[_t])}}}M(A)&&A.mipmapsAutoUpdate===!0&&v(i.TEXTURE_CUBE_MAP),ot.__version=Q.version,A.onUpdate&&A.onUpdate(A)}R.__version=A.version}function ge(R,A,k,et,Q,ot){let ut=r.convert(k.format,k.colorSpace),Z=r.convert(k.type),J=w(k.internalFormat,ut,Z,k.normalized,k.colorSpace),ct=n.get(A),D=n.get(k);if(D.__renderTarget=A,!ct.__hasExternalTextures){let K=Math.max(1,A.width>>ot),$=Math.max(1,A.height>>ot);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?e.texImage3D(Q,ot,J,K,$,A.depth,0,ut,Z,null):e.texImage2D(Q,ot,J,K,$,0,ut,Z,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),mt(A)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,et,Q,D.__webglTexture,0,we(A)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,et,Q,D.__webglTexture,ot),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Cn(R,A,k){if(i.bindRenderbuffer(i.RENDERBUFFER,R),A.depthBuffer){let et=A.depthTexture,Q=et&&et.isDepthTexture?et.type:null,ot=y(A.stencilBuffer,Q),ut=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;mt(A)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,we(A),ot,A.width,A.height):k?i.renderbufferStorageMultisample(i.RENDERBUFFER,we(A),ot,A.width,A.height):i.renderbufferStorage(i.RENDERBUFFER,ot,A.width,A.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ut,i.RENDERBUFFER,R)}else{let et=A.textures;for(let Q=0;Q<et.length;Q++){let ot=et[Q],ut=r.convert(ot.format,ot.colorSpace),Z=r.convert(ot.type),J=w(ot.internalFormat,ut,Z,ot.normalized,ot.colorSpace);mt(A)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,we(A),J,A.width,A.height):k?i.renderbufferStorageMultisample(i.RENDERBUFFER,we(A),J,A.width,A.height):i.renderbufferStorage(i.RENDERBUFFER,J,A.width,A.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Le(R,A,k){let et=A.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(A.depthTexture&&A.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(A.depthTexture);Q.__renderTarget=A;let ot=et?A.depthTexture.image[0]:A.depthTexture.image;(!Q.__webglTexture||ot.width!==A.width||ot.height!==A.height)&&(ot.width=A.width,ot.height=A.height,A.depthTexture.needsUpdate=!0),et?pt(A.depthTexture,0):rt(A.depthTexture,0);let ut=Q.__webglTexture,Z=we(A),J=et?i.TEXTURE_CUBE_MAP_POSITIVE_X+k:i.TEXTURE_2D,ct=A.depthTexture.format===Xi?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(A.depthTexture.format===Vi)mt(A)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ct,J,ut,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,ct,J,ut,0);else if(A.depthTexture.format===Xi)mt(A)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ct,J,ut,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,ct,J,ut,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function un(R){let A=n.get(R),k=R.isWebGLCubeRenderTarget===!0;if(A.__boundDepthTexture!==R.depthTexture){let et=R.depthTexture;if(A.__depthDisposeCallback&&A.__depthDisposeCallback(),et){let Q=()=>{delete A.__boundDepthTexture,delete A.__depthDisposeCallback,et.removeEventListener("dispose",Q)};et.addEventListener("dispose",Q),A.__depthDisposeCallback=Q}A.__boundDepthTexture=et}if(R.depthTexture&&!A.__autoAllocateDepthBuffer)if(k)for(let et=0;et<6;et++)Le(A.__webglFramebuffer[et],R,et);else R.texture.mipmaps.length>0?Le(A.__webglFramebuffer[0],R,0):Le(A.__webglFramebuffer,R,0);else if(k){A.__webglDepthbuffer=[];for(let et=0;et<6;et++)if(e.bindFramebuffer(i.FRAMEBUFFER,A.__webglFramebuffer[et]),A.__webglDepthbuffer[et]===void 0)A.__webglDepthbuffer[et]=i.createRenderbuffer(),Cn(A.__webglDepthbuffer[et],R,!1);else{let Q=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ot=A.__webglDepthbuffer[et];i.bindRenderbuffer(i.RENDERBUFFER,ot),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,ot)}}else if(R.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,A.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,A.__webglFramebuffer),A.__webglDepthbuffer===void 0)A.__webglDepthbuffer=i.createRenderbuffer(),Cn(A.__webglDepthbuffer,R,!1);else{let Q=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ot=A.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ot),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,ot)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Gn(R,A,k){let et=n.get(R);A!==void 0&&ge(et.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),k!==void 0&&un(R)}function Vn(R){let A=R.texture,k=n.get(R),et=n.get(A);R.addEventListener("dispose",N),I(R);let Q=R.textures,ot=R.isWebGLCubeRenderTarget===!0,ut=Q.length>1;if(ut||(et.__webglTexture===void 0&&(et.__webglTexture=i.createTexture()),et.__version=A.version,o.memory.textures++),ot){k.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(A.mipmaps.length>0){k.__webglFramebuffer[Z]=[];for(let J=0;J<A.mipmaps.length;J++)k.__webglFramebuffer[Z][J]=i.createFramebuffer()}else k.__webglFramebuffer[Z]=i.createFramebuffer()}else{if(A.mipmaps.length>0){k.__webglFramebuffer=[];for(let Z=0;Z<A.mipmaps.length;Z++)k.__webglFramebuffer[Z]=i.createFramebuffer()}else k.__webglFramebuffer=i.createFramebuffer();if(ut)for(let Z=0,J=Q.length;Z<J;Z++){let ct=n.get(Q[Z]);ct.__webglTexture===void 0&&(ct.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&mt(R)===!1){k.__webglMultisampledFramebuffer=i.createFramebuffer(),k.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,k.__webglMultisampledFramebuffer);for(let Z=0;Z<Q.length;Z++){let J=Q[Z];k.__webglColorRenderbuffer[Z]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,k.__webglColorRenderbuffer[Z]);let ct=r.convert(J.format,J.colorSpace),D=r.convert(J.type),K=w(J.internalFormat,ct,D,J.normalized,J.colorSpace,R.isXRRenderTarget===!0),$=we(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,$,K,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Z,i.RENDERBUFFER,k.__webglColorRenderbuffer[Z])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(k.__webglDepthRenderbuffer=i.createRenderbuffer(),Cn(k.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ot){e.bindTexture(i.TEXTURE_CUBE_MAP,et.__webglTexture),Zt(i.TEXTURE_CUBE_MAP,A);for(let Z=0;Z<6;Z++)if(A.mipmaps.length>0)for(let J=0;J<A.mipmaps.length;J++)ge(k.__webglFramebuffer[Z][J],R,A,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,J);else ge(k.__webglFramebuffer[Z],R,A,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);M(A)?v(i.TEXTURE_CUBE_MAP):A.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,A.mipmaps.length-1),e.unbindTexture()}else if(ut){for(let Z=0,J=Q.length;Z<J;Z++){let ct=Q[Z],D=n.get(ct),K=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(K=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(K,D.__webglTexture),Zt(K,ct),ge(k.__webglFramebuffer,R,ct,i.COLOR_ATTACHMENT0+Z,K,0),M(ct)&&v(K)}e.unbindTexture()}else{let Z=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(Z=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(Z,et.__webglTexture),Zt(Z,A),A.mipmaps.length>0)for(let J=0;J<A.mipmaps.length;J++)ge(k.__webglFramebuffer[J],R,A,i.COLOR_ATTACHMENT0,Z,J);else ge(k.__webglFramebuffer,R,A,i.COLOR_ATTACHMENT0,Z,0);M(A)?v(Z):A.mipmaps.length>0&&i.texParameteri(Z,i.TEXTURE_MAX_LEVEL,A.mipmaps.length-1),e.unbindTexture()}R.depthBuffer&&un(R)}function O(R){let A=R.textures;for(let k=0,et=A.length;k<et;k++){let Q=A[k];if(M(Q)&&Q.mipmapsAutoUpdate===!0){let ot=b(R),ut=n.get(Q).__webglTexture;e.bindTexture(ot,ut),v(ot),e.unbindTexture()}}}let Hn=[];function be(R){if(R.samples>0){if(mt(R)===!1){let A=R.textures,k=R.width,et=R.height,Q=i.COLOR_BUFFER_BIT,ot=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ut=n.get(R),Z=A.length>1;if(Z)for(let ct=0;ct<A.length;ct++)e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ut.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ut.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ut.__webglFramebuffer);for(let ct=0;ct<A.length;ct++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),Z){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ut.__webglColorRenderbuffer[ct]);let D=n.get(A[ct]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,D,0)}i.blitFramebuffer(0,0,k,et,0,0,k,et,Q,i.NEAREST),c===!0&&(Hn.length=0,Hn.push(i.COLOR_ATTACHMENT0+ct),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Hn.push(ot),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Hn))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Z)for(let ct=0;ct<A.length;ct++){e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.RENDERBUFFER,ut.__webglColorRenderbuffer[ct]);let D=n.get(A[ct]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.TEXTURE_2D,D,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ut.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&c){let A=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[A])}}}function we(R){return Math.min(s.maxSamples,R.samples)}function mt(R){let A=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&A.__useRenderToTexture!==!1}function Fe(R){let A=o.render.frame;h.get(R)!==A&&(h.set(R,A),R.update())}function Lt(R,A){let k=R.colorSpace,et=R.format,Q=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||k!==Po&&k!==$i&&(jt.getTransfer(k)===oe?(et!==li||Q!==An)&&Pt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ut("WebGLTextures: Unsupported texture color space:",k)),A}function Bt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(l.width=R.naturalWidth||R.width,l.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(l.width=R.displayWidth,l.height=R.displayHeight):(l.width=R.width,l.height=R.height),l}this.allocateTextureUnit=wt,this.resetTextureUnits=Y,this.getTextureUnits=tt,this.setTextureUnits=gt,this.setTexture2D=rt,this.setTexture2DArray=xt,this.setTexture3D=At,this.setTextureCube=pt,this.rebindTextures=Gn,this.setupRenderTarget=Vn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=be,this.setupDepthRenderbuffer=un,this.setupFrameBufferTexture=ge,this.useMultisampledRTT=mt,this.dispose=B}function B1(i,t){function e(n,s=$i){let r,o=jt.getTransfer(s);if(n===An)return i.UNSIGNED_BYTE;if(n===cl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===ll)return i.UNSIGNED_SHORT_5_5_5_1;if(n===ed)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===nd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Qu)return i.BYTE;if(n===td)return i.SHORT;if(n===Hr)return i.UNSIGNED_SHORT;if(n===al)return i.INT;if(n===ai)return i.UNSIGNED_INT;if(n===Zn)return i.FLOAT;if(n===ci)return i.HALF_FLOAT;if(n===id)return i.ALPHA;if(n===sd)return i.RGB;if(n===li)return i.RGBA;if(n===Vi)return i.DEPTH_COMPONENT;if(n===Xi)return i.DEPTH_STENCIL;if(n===hl)return i.RED;if(n===ul)return i.RED_INTEGER;if(n===Ms)return i.RG;if(n===dl)return i.RG_INTEGER;if(n===fl)return i.RGBA_INTEGER;if(n===ca||n===la||n===ha||n===ua)if(o===oe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ca)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===la)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===ha)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ua)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ca)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===la)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===ha)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ua)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===pl||n===ml||n===gl||n===xl)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===pl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ml)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===gl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===xl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===_l||n===yl||n===vl||n===Ml||n===Sl||n===da||n===bl)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===_l||n===yl)return o===oe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===vl)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Ml)return r.COMPRESSED_R11_EAC;if(n===Sl)return r.COMPRESSED_SIGNED_R11_EAC;if(n===da)return r.COMPRESSED_RG11_EAC;if(n===bl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===wl||n===Al||n===El||n===Tl||n===Rl||n===Cl||n===Il||n===Pl||n===Ll||n===Nl||n===Dl||n===Ul||n===Ol||n===Fl)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===wl)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Al)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===El)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Tl)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Rl)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Cl)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Il)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Pl)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ll)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Nl)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Dl)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Ul)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Ol)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Fl)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Bl||n===zl||n===kl)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Bl)return o===oe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===zl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===kl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Gl||n===Vl||n===fa||n===Hl)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Gl)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Vl)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===fa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Hl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===er?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var z1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,k1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Ed=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new qo(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Yn({vertexShader:z1,fragmentShader:k1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Yt(new Ks(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Td=class extends vi{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,u=null,d=null,f=null,p=null,g=typeof XRWebGLBinding<"u",m=new Ed,x={},_=e.getContextAttributes(),M=null,v=null,b=[],w=[],y=new Gt,S=null,I=null,T=new pn;T.viewport=new ce;let L=new pn;L.viewport=new ce;let N=[T,L],F=new il,P=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(X){let rt=b[X];return rt===void 0&&(rt=new Nr,b[X]=rt),rt.getTargetRaySpace()},this.getControllerGrip=function(X){let rt=b[X];return rt===void 0&&(rt=new Nr,b[X]=rt),rt.getGripSpace()},this.getHand=function(X){let rt=b[X];return rt===void 0&&(rt=new Nr,b[X]=rt),rt.getHandSpace()};function G(X){let rt=w.indexOf(X.inputSource);if(rt===-1)return;let xt=b[rt];xt!==void 0&&(xt.update(X.inputSource,X.frame,l||o),xt.dispatchEvent({type:X.type,data:X.inputSource}))}function H(){s.removeEventListener("select",G),s.removeEventListener("selectstart",G),s.removeEventListener("selectend",G),s.removeEventListener("squeeze",G),s.removeEventListener("squeezestart",G),s.removeEventListener("squeezeend",G),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",j);for(let X=0;X<b.length;X++){let rt=w[X];rt!==null&&(w[X]=null,b[X].disconnect(rt))}P=null,B=null,m.reset();for(let X in x)delete x[X];if(t.setRenderTarget(M),f=null,d=null,u=null,s=null,v=null,wt.stop(),n.isPresenting=!1,t.setPixelRatio(S),t.setSize(y.width,y.height,!1),I!==null){let X=I.camera;X.fov=I.fov,X.zoom=I.zoom,X.updateProjectionMatrix(),I=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(X){r=X,n.isPresenting===!0&&Pt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(X){a=X,n.isPresenting===!0&&Pt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(X){l=X},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&g&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(X){if(s=X,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",G),s.addEventListener("selectstart",G),s.addEventListener("selectend",G),s.addEventListener("squeeze",G),s.addEventListener("squeezestart",G),s.addEventListener("squeezeend",G),s.addEventListener("end",H),s.addEventListener("inputsourceschange",j),_.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(y),g&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,At=null,pt=null;_.depth&&(pt=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=_.stencil?Xi:Vi,At=_.stencil?er:ai);let Dt={colorFormat:e.RGBA8,depthFormat:pt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Dt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new Nn(d.textureWidth,d.textureHeight,{format:li,type:An,depthTexture:new Hi(d.textureWidth,d.textureHeight,At,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new Nn(f.framebufferWidth,f.framebufferHeight,{format:li,type:An,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),wt.setContext(s),wt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function j(X){for(let rt=0;rt<X.removed.length;rt++){let xt=X.removed[rt],At=w.indexOf(xt);At>=0&&(w[At]=null,b[At].disconnect(xt))}for(let rt=0;rt<X.added.length;rt++){let xt=X.added[rt],At=w.indexOf(xt);if(At===-1){for(let Dt=0;Dt<b.length;Dt++)if(Dt>=w.length){w.push(xt),At=Dt;break}else if(w[Dt]===null){w[Dt]=xt,At=Dt;break}if(At===-1)break}let pt=b[At];pt&&pt.connect(xt)}}function W(X,rt){rt===null?X.matrixWorld.copy(X.matrix):X.matrixWorld.multiplyMatrices(rt.matrixWorld,X.matrix),X.matrixWorldInverse.copy(X.matrixWorld).invert()}this.updateCamera=function(X){if(s===null)return;let rt=X.near,xt=X.far;m.texture!==null&&(m.depthNear>0&&(rt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),F.near=L.near=T.near=rt,F.far=L.far=T.far=xt,(P!==F.near||B!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),P=F.near,B=F.far),F.layers.mask=X.layers.mask|6,T.layers.mask=F.layers.mask&-5,L.layers.mask=F.layers.mask&-3;let At=X.parent,pt=F.cameras;W(F,At);for(let Dt=0;Dt<pt.length;Dt++)W(pt[Dt],At);F.projectionMatrix.copy(T.projectionMatrix),F.projectionMatrixInverse.copy(T.projectionMatrixInverse),I===null&&X.isPerspectiveCamera&&(I={camera:X,fov:X.fov,zoom:X.zoom}),Y(X,F,At)};function Y(X,rt,xt){xt===null?X.matrix.copy(rt.matrixWorld):(X.matrix.copy(xt.matrixWorld),X.matrix.invert(),X.matrix.multiply(rt.matrixWorld)),X.matrix.decompose(X.position,X.quaternion,X.scale),X.updateMatrixWorld(!0),X.projectionMatrix.copy(rt.projectionMatrix),X.projectionMatrixInverse.copy(rt.projectionMatrixInverse),X.isPerspectiveCamera&&(X.fov=Pr*2*Math.atan(1/X.projectionMatrix.elements[5]),X.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(X){c=X,d!==null&&(d.fixedFoveation=X),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=X)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(F)},this.getCameraTexture=function(X){return x[X]};let tt=null;function gt(X,rt){if(h=rt.getViewerPose(l||o),p=rt,h!==null){let xt=h.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let At=!1;xt.length!==F.cameras.length&&(F.cameras.length=0,At=!0);for(let Rt=0;Rt<xt.length;Rt++){let Zt=xt[Rt],te=null;if(f!==null)te=f.getViewport(Zt);else{let Te=u.getViewSubImage(d,Zt);te=Te.viewport,Rt===0&&(t.setRenderTargetTextures(v,Te.colorTexture,Te.depthStencilTexture),t.setRenderTarget(v))}let Vt=N[Rt];Vt===void 0&&(Vt=new pn,Vt.layers.enable(Rt),Vt.viewport=new ce,N[Rt]=Vt),Vt.matrix.fromArray(Zt.transform.matrix),Vt.matrix.decompose(Vt.position,Vt.quaternion,Vt.scale),Vt.projectionMatrix.fromArray(Zt.projectionMatrix),Vt.projectionMatrixInverse.copy(Vt.projectionMatrix).invert(),Vt.viewport.set(te.x,te.y,te.width,te.height),Rt===0&&(F.matrix.copy(Vt.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),At===!0&&F.cameras.push(Vt)}let pt=s.enabledFeatures;if(pt&&pt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&g){u=n.getBinding();let Rt=u.getDepthInformation(xt[0]);Rt&&Rt.isValid&&Rt.texture&&m.init(Rt,s.renderState)}if(pt&&pt.includes("camera-access")&&g){t.state.unbindTexture(),u=n.getBinding();for(let Rt=0;Rt<xt.length;Rt++){let Zt=xt[Rt].camera;if(Zt){let te=x[Zt];te||(te=new qo,x[Zt]=te);let Vt=u.getCameraImage(Zt);te.sourceTexture=Vt}}}}for(let xt=0;xt<b.length;xt++){let At=w[xt],pt=b[xt];At!==null&&pt!==void 0&&pt.update(At,rt,l||o)}tt&&tt(X,rt),rt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:rt}),p=null}let wt=new Wm;wt.setAnimationLoop(gt),this.setAnimationLoop=function(X){tt=X},this.dispose=function(){}}},G1=new Qt,tg=new Ft;tg.set(-1,0,0,0,1,0,0,0,1);function V1(i,t){function e(m,x){m.matrixAutoUpdate===!0&&m.updateMatrix(),x.value.copy(m.matrix)}function n(m,x){x.color.getRGB(m.fogColor.value,pd(i)),x.isFog?(m.fogNear.value=x.near,m.fogFar.value=x.far):x.isFogExp2&&(m.fogDensity.value=x.density)}function s(m,x,_,M,v){x.isNodeMaterial?x.uniformsNeedUpdate=!1:x.isMeshBasicMaterial?r(m,x):x.isMeshLambertMaterial?(r(m,x),x.envMap&&(m.envMapIntensity.value=x.envMapIntensity)):x.isMeshToonMaterial?(r(m,x),u(m,x)):x.isMeshPhongMaterial?(r(m,x),h(m,x),x.envMap&&(m.envMapIntensity.value=x.envMapIntensity)):x.isMeshStandardMaterial?(r(m,x),d(m,x),x.isMeshPhysicalMaterial&&f(m,x,v)):x.isMeshMatcapMaterial?(r(m,x),p(m,x)):x.isMeshDepthMaterial?r(m,x):x.isMeshDistanceMaterial?(r(m,x),g(m,x)):x.isMeshNormalMaterial?r(m,x):x.isLineBasicMaterial?(o(m,x),x.isLineDashedMaterial&&a(m,x)):x.isPointsMaterial?c(m,x,_,M):x.isSpriteMaterial?l(m,x):x.isShadowMaterial?(m.color.value.copy(x.color),m.opacity.value=x.opacity):x.isShaderMaterial&&(x.uniformsNeedUpdate=!1)}function r(m,x){m.opacity.value=x.opacity,x.color&&m.diffuse.value.copy(x.color),x.emissive&&m.emissive.value.copy(x.emissive).multiplyScalar(x.emissiveIntensity),x.map&&(m.map.value=x.map,e(x.map,m.mapTransform)),x.alphaMap&&(m.alphaMap.value=x.alphaMap,e(x.alphaMap,m.alphaMapTransform)),x.bumpMap&&(m.bumpMap.value=x.bumpMap,e(x.bumpMap,m.bumpMapTransform),m.bumpScale.value=x.bumpScale,x.side===xn&&(m.bumpScale.value*=-1)),x.normalMap&&(m.normalMap.value=x.normalMap,e(x.normalMap,m.normalMapTransform),m.normalScale.value.copy(x.normalScale),x.side===xn&&m.normalScale.value.negate()),x.displacementMap&&(m.displacementMap.value=x.displacementMap,e(x.displacementMap,m.displacementMapTransform),m.displacementScale.value=x.displacementScale,m.displacementBias.value=x.displacementBias),x.emissiveMap&&(m.emissiveMap.value=x.emissiveMap,e(x.emissiveMap,m.emissiveMapTransform)),x.specularMap&&(m.specularMap.value=x.specularMap,e(x.specularMap,m.specularMapTransform)),x.alphaTest>0&&(m.alphaTest.value=x.alphaTest);let _=t.get(x),M=_.envMap,v=_.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(G1.makeRotationFromEuler(v)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(tg),m.reflectivity.value=x.reflectivity,m.ior.value=x.ior,m.refractionRatio.value=x.refractionRatio),x.lightMap&&(m.lightMap.value=x.lightMap,m.lightMapIntensity.value=x.lightMapIntensity,e(x.lightMap,m.lightMapTransform)),x.aoMap&&(m.aoMap.value=x.aoMap,m.aoMapIntensity.value=x.aoMapIntensity,e(x.aoMap,m.aoMapTransform))}function o(m,x){m.diffuse.value.copy(x.color),m.opacity.value=x.opacity,x.map&&(m.map.value=x.map,e(x.map,m.mapTransform))}function a(m,x){m.dashSize.value=x.dashSize,m.totalSize.value=x.dashSize+x.gapSize,m.scale.value=x.scale}function c(m,x,_,M){m.diffuse.value.copy(x.color),m.opacity.value=x.opacity,m.size.value=x.size*_,m.scale.value=M*.5,x.map&&(m.map.value=x.map,e(x.map,m.uvTransform)),x.alphaMap&&(m.alphaMap.value=x.alphaMap,e(x.alphaMap,m.alphaMapTransform)),x.alphaTest>0&&(m.alphaTest.value=x.alphaTest)}function l(m,x){m.diffuse.value.copy(x.color),m.opacity.value=x.opacity,m.rotation.value=x.rotation,x.map&&(m.map.value=x.map,e(x.map,m.mapTransform)),x.alphaMap&&(m.alphaMap.value=x.alphaMap,e(x.alphaMap,m.alphaMapTransform)),x.alphaTest>0&&(m.alphaTest.value=x.alphaTest)}function h(m,x){m.specular.value.copy(x.specular),m.shininess.value=Math.max(x.shininess,1e-4)}function u(m,x){x.gradientMap&&(m.gradientMap.value=x.gradientMap)}function d(m,x){m.metalness.value=x.metalness,x.metalnessMap&&(m.metalnessMap.value=x.metalnessMap,e(x.metalnessMap,m.metalnessMapTransform)),m.roughness.value=x.roughness,x.roughnessMap&&(m.roughnessMap.value=x.roughnessMap,e(x.roughnessMap,m.roughnessMapTransform)),x.envMap&&(m.envMapIntensity.value=x.envMapIntensity)}function f(m,x,_){m.ior.value=x.ior,x.diffuseRoughness>0&&(m.diffuseRoughness.value=x.diffuseRoughness,x.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=x.diffuseRoughnessMap,e(x.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),x.sheen>0&&(m.sheenColor.value.copy(x.sheenColor).multiplyScalar(x.sheen),m.sheenRoughness.value=x.sheenRoughness,x.sheenColorMap&&(m.sheenColorMap.value=x.sheenColorMap,e(x.sheenColorMap,m.sheenColorMapTransform)),x.sheenRoughnessMap&&(m.sheenRoughnessMap.value=x.sheenRoughnessMap,e(x.sheenRoughnessMap,m.sheenRoughnessMapTransform))),x.clearcoat>0&&(m.clearcoat.value=x.clearcoat,m.clearcoatRoughness.value=x.clearcoatRoughness,x.clearcoatMap&&(m.clearcoatMap.value=x.clearcoatMap,e(x.clearcoatMap,m.clearcoatMapTransform)),x.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=x.clearcoatRoughnessMap,e(x.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),x.clearcoatNormalMap&&(m.clearcoatNormalMap.value=x.clearcoatNormalMap,e(x.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(x.clearcoatNormalScale),x.side===xn&&m.clearcoatNormalScale.value.negate())),x.dispersion>0&&(m.dispersion.value=x.dispersion),x.retroreflectivity>0&&(m.retroreflectivity.value=x.retroreflectivity),x.iridescence>0&&(m.iridescence.value=x.iridescence,m.iridescenceIOR.value=x.iridescenceIOR,m.iridescenceThicknessMinimum.value=x.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=x.iridescenceThicknessMaximum,x.iridescenceMap&&(m.iridescenceMap.value=x.iridescenceMap,e(x.iridescenceMap,m.iridescenceMapTransform)),x.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=x.iridescenceThicknessMap,e(x.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),x.transmission>0&&(m.transmission.value=x.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),x.transmissionMap&&(m.transmissionMap.value=x.transmissionMap,e(x.transmissionMap,m.transmissionMapTransform)),m.thickness.value=x.thickness,x.thicknessMap&&(m.thicknessMap.value=x.thicknessMap,e(x.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=x.attenuationDistance,m.attenuationColor.value.copy(x.attenuationColor)),x.anisotropy>0&&(m.anisotropyVector.value.set(x.anisotropy*Math.cos(x.anisotropyRotation),x.anisotropy*Math.sin(x.anisotropyRotation)),x.anisotropyMap&&(m.anisotropyMap.value=x.anisotropyMap,e(x.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=x.specularIntensity,m.specularColor.value.copy(x.specularColor),x.specularColorMap&&(m.specularColorMap.value=x.specularColorMap,e(x.specularColorMap,m.specularColorMapTransform)),x.specularIntensityMap&&(m.specularIntensityMap.value=x.specularIntensityMap,e(x.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,x){x.matcap&&(m.matcap.value=x.matcap)}function g(m,x){let _=t.get(x).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function H1(i,t,e,n){let s={},r={};function o(_,M){let v=M.program;n.uniformBlockBinding(_,v,s[_.id])}function a(_,M){let v=s[_.id];v===void 0&&(p(_),v=c(_),s[_.id]=v,_.addEventListener("dispose",m));let b=M.program;n.updateUBOMapping(_,b);let w=t.render.frame;r[_.id]!==w&&(l(_),r[_.id]=w)}function c(_){let M=i.createBuffer(),v=_.__size,b=_.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,v,b),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function l(_){let M=s[_.id],v=_.uniforms,b=_.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let w=0,y=v.length;w<y;w++){let S=v[w];if(Array.isArray(S))for(let I=0,T=S.length;I<T;I++)h(S[I],w,I,b);else h(S,w,0,b)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(_,M,v,b){if(d(_,M,v,b)===!0){let w=_.__offset,y=_.value;if(Array.isArray(y)){let S=0;for(let I=0;I<y.length;I++){let T=y[I],L=g(T,!0);u(T,_.__data,S),S+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,_.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,w,_.__data)}}function u(_,M,v){typeof _=="number"||typeof _=="boolean"?M[v]=_:_.isMatrix3?(M[v]=_.elements[0],M[v+1]=_.elements[1],M[v+2]=_.elements[2],M[v+3]=0,M[v+4]=_.elements[3],M[v+5]=_.elements[4],M[v+6]=_.elements[5],M[v+7]=0,M[v+8]=_.elements[6],M[v+9]=_.elements[7],M[v+10]=_.elements[8],M[v+11]=0):ArrayBuffer.isView(_)?M.set(_.subarray(0,M.length-v),v):_.toArray(M,v)}function d(_,M,v,b){let w=_.value,y=M+"_"+v;if(Array.isArray(w)){b[y]===void 0&&(b[y]=[]);let S=b[y],I=!1;for(let T=0;T<w.length;T++)f(w[T],S,T)===!0&&(I=!0);return I}return f(w,b,y)}function f(_,M,v){if(M[v]===void 0)return typeof _=="number"||typeof _=="boolean"?M[v]=_:ArrayBuffer.isView(_)?M[v]=_.slice():M[v]=_.clone(),!0;{let b=M[v];if(typeof _=="number"||typeof _=="boolean"){if(b!==_)return M[v]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(b.equals(_)===!1)return b.copy(_),!0}}return!1}function p(_){let M=_.uniforms,v=0,b=16;for(let y=0,S=M.length;y<S;y++){let I=Array.isArray(M[y])?M[y]:[M[y]];for(let T=0,L=I.length;T<L;T++){let N=I[T],F=Array.isArray(N.value)?N.value:[N.value],P=Array.isArray(M[y])||Array.isArray(N.value),B=v;for(let H=0,j=F.length;H<j;H++){let W=F[H],Y=g(W,P),tt=v%b,gt=tt%Y.boundary,wt=tt+gt;v+=gt,wt!==0&&b-wt<Y.storage&&(v+=b-wt),H===0&&(B=v),v+=Y.storage}let G=N.type==="int"?Int32Array:N.type==="uint"?Uint32Array:Float32Array;N.__data=new G((v-B)/Float32Array.BYTES_PER_ELEMENT),N.__offset=B}}let w=v%b;return w>0&&(v+=b-w),_.__size=v,_.__cache={},this}function g(_,M){let v={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(v.boundary=4,v.storage=4):_.isVector2?(v.boundary=8,v.storage=8):_.isVector3||_.isColor?(v.boundary=16,v.storage=12):_.isVector4?(v.boundary=16,v.storage=16):_.isMatrix3?(v.boundary=16,v.storage=48):_.isMatrix4?(v.boundary=16,v.storage=64):_.isTexture?Pt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(v.boundary=16,v.storage=_.byteLength):Pt("WebGLRenderer: Unsupported uniform value type.",_),M===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(_){let M=_.target;M.removeEventListener("dispose",m),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function x(){for(let _ in s)i.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:x}}var W1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),wi=null;function q1(){return wi===null&&(wi=new ri(W1,16,16,Ms,ci),wi.name="DFG_LUT",wi.minFilter=Be,wi.magFilter=Be,wi.wrapS=yi,wi.wrapT=yi,wi.generateMipmaps=!1,wi.needsUpdate=!0),wi}var Zl=class{constructor(t={}){let{canvas:e=gm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=An}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let g=f,m=new Set([fl,dl,ul]),x=new Set([An,ai,Hr,er,cl,ll]),_=new Uint32Array(4),M=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},b=null,w=null,y=[],S=[],I=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=bi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,L=!1,N=null,F=null,P=null,B=null;this._outputColorSpace=Ln;let G=0,H=0,j=null,W=-1,Y=null,tt=new ce,gt=new ce,wt=null,X=new Ot(0),rt=0,xt=e.width,At=e.height,pt=1,Dt=null,me=null,Rt=new ce(0,0,xt,At),Zt=new ce(0,0,xt,At),te=!1,Vt=new fs,Te=new zc,Me=!1,se=!1,ge=new Qt,Cn=new C,Le=new ce,un={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Gn=!1;function Vn(){return j===null?pt:1}let O=n;function Hn(E,U){return e.getContext(E,U)}let be,we,mt,Fe,Lt,Bt,R,A,k,et,Q,ot,ut,Z,J,ct,D,K,$,lt,it,at,Ct;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",It,!1),e.addEventListener("webglcontextrestored",qt,!1),e.addEventListener("webglcontextcreationerror",_t,!1),O===null){let U="webgl2";if(O=Hn(U,E),O===null)throw Hn(U)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Xt()}catch(E){throw e.removeEventListener("webglcontextlost",It,!1),e.removeEventListener("webglcontextrestored",qt,!1),e.removeEventListener("webglcontextcreationerror",_t,!1),Ut("WebGLRenderer: "+E.message),E}function Xt(){be=new nb(O),be.init(),it=new B1(O,be),we=new qS(O,be,t,it),mt=new O1(O,be),we.reversedDepthBuffer&&d&&mt.buffers.depth.setReversed(!0),F=O.createFramebuffer(),P=O.createFramebuffer(),B=O.createFramebuffer(),Fe=new rb(O),Lt=new S1,Bt=new F1(O,be,mt,Lt,we,it,Fe),R=new eb(T),A=new av(O),at=new HS(O,A),k=new ib(O,A,Fe,at),et=new ab(O,k,A,at,Fe),K=new ob(O,we,Bt),J=new XS(Lt),Q=new M1(T,R,be,we,at,J),ot=new V1(T,Lt),ut=new w1,Z=new I1(be),D=new VS(T,R,mt,et,p,c),ct=new U1(T,et,we),Ct=new H1(O,Fe,we,mt),$=new WS(O,be,Fe),lt=new sb(O,be,Fe),Fe.programs=Q.programs,T.capabilities=we,T.extensions=be,T.properties=Lt,T.renderLists=ut,T.shadowMap=ct,T.state=mt,T.info=Fe}g!==An&&(I=new lb(g,e.width,e.height,a,s,r));let nt=new Td(T,O);this.xr=nt,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let E=be.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=be.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return pt},this.setPixelRatio=function(E){E!==void 0&&(pt=E,this.setSize(xt,At,!1))},this.getSize=function(E){return E.set(xt,At)},this.setSize=function(E,U,q=!0){if(nt.isPresenting){Pt("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=E,At=U,e.width=Math.floor(E*pt),e.height=Math.floor(U*pt),q===!0&&(e.style.width=E+"px",e.style.height=U+"px"),I!==null&&I.setSize(e.width,e.height),this.setViewport(0,0,E,U)},this.getDrawingBufferSize=function(E){return E.set(xt*pt,At*pt).floor()},this.setDrawingBufferSize=function(E,U,q){xt=E,At=U,pt=q,e.width=Math.floor(E*q),e.height=Math.floor(U*q),this.setViewport(0,0,E,U)},this.setEffects=function(E){if(g===An){Ut("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let U=0;U<E.length;U++)if(E[U].isOutputPass===!0){Pt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(tt)},this.getViewport=function(E){return E.copy(Rt)},this.setViewport=function(E,U,q,z){E.isVector4?Rt.set(E.x,E.y,E.z,E.w):Rt.set(E,U,q,z),mt.viewport(tt.copy(Rt).multiplyScalar(Vn()).round())},this.getScissor=function(E){return E.copy(Zt)},this.setScissor=function(E,U,q,z){E.isVector4?Zt.set(E.x,E.y,E.z,E.w):Zt.set(E,U,q,z),mt.scissor(gt.copy(Zt).multiplyScalar(Vn()).round())},this.getScissorTest=function(){return te},this.setScissorTest=function(E){mt.setScissorTest(te=E)},this.setOpaqueSort=function(E){Dt=E},this.setTransparentSort=function(E){me=E},this.getClearColor=function(E){return E.copy(D.getClearColor())},this.setClearColor=function(){D.setClearColor(...arguments)},this.getClearAlpha=function(){return D.getClearAlpha()},this.setClearAlpha=function(){D.setClearAlpha(...arguments)},this.clear=function(E=!0,U=!0,q=!0){let z=0;if(E){let V=!1;if(j!==null){let dt=j.texture.format;V=m.has(dt)}if(V){let dt=j.texture.type,Mt=x.has(dt),ht=D.getClearColor(),yt=D.getClearAlpha(),Et=ht.r,kt=ht.g,Jt=ht.b;Mt?(_[0]=Et,_[1]=kt,_[2]=Jt,_[3]=yt,O.clearBufferuiv(O.COLOR,0,_)):(M[0]=Et,M[1]=kt,M[2]=Jt,M[3]=yt,O.clearBufferiv(O.COLOR,0,M))}else z|=O.COLOR_BUFFER_BIT}U&&(z|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),q&&(z|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),z!==0&&O.clear(z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),N=E},this.dispose=function(){e.removeEventListener("webglcontextlost",It,!1),e.removeEventListener("webglcontextrestored",qt,!1),e.removeEventListener("webglcontextcreationerror",_t,!1),D.dispose(),ut.dispose(),Z.dispose(),Bt.dispose(),Lt.dispose(),R.dispose(),et.dispose(),k.dispose(),at.dispose(),Ct.dispose(),Q.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Xf),nt.removeEventListener("sessionend",$f),Hs.stop()};function It(E){E.preventDefault(),Do("WebGLRenderer: Context Lost."),L=!0}function qt(){Do("WebGLRenderer: Context Restored."),L=!1;let E=Fe.autoReset,U=ct.enabled,q=ct.autoUpdate,z=ct.needsUpdate,V=ct.type;Xt(),Fe.autoReset=E,ct.enabled=U,ct.autoUpdate=q,ct.needsUpdate=z,ct.type=V}function _t(E){Ut("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function le(E){let U=E.target;U.removeEventListener("dispose",le),We(U)}function We(E){rs(E),Lt.remove(E)}function rs(E){let U=Lt.get(E).programs;U!==void 0&&(U.forEach(function(q){Q.releaseProgram(q)}),E.isShaderMaterial&&Q.releaseShaderCache(E))}this.renderBufferDirect=function(E,U,q,z,V,dt){U===null&&(U=un);let Mt=V.isMesh&&V.matrixWorld.determinantAffine()<0,ht=Q_(E,U,q,z,V);mt.setMaterial(z,Mt);let yt=q.index,Et=1;if(z.wireframe===!0){if(yt=k.getWireframeAttribute(q),yt===void 0)return;Et=2}let kt=q.drawRange,Jt=q.attributes.position,St=kt.start*Et,Kt=(kt.start+kt.count)*Et;dt!==null&&(St=Math.max(St,dt.start*Et),Kt=Math.min(Kt,(dt.start+dt.count)*Et)),yt!==null?(St=Math.max(St,0),Kt=Math.min(Kt,yt.count)):Jt!=null&&(St=Math.max(St,0),Kt=Math.min(Kt,Jt.count));let Ue=Kt-St;if(Ue<0||Ue===1/0)return;at.setup(V,z,ht,q,yt);let xe,pe=$;if(yt!==null&&(xe=A.get(yt),pe=lt,pe.setIndex(xe)),V.isMesh)z.wireframe===!0?(mt.setLineWidth(z.wireframeLinewidth*Vn()),pe.setMode(O.LINES)):pe.setMode(O.TRIANGLES);else if(V.isLine){let rn=z.linewidth;rn===void 0&&(rn=1),mt.setLineWidth(rn*Vn()),V.isLineSegments?pe.setMode(O.LINES):V.isLineLoop?pe.setMode(O.LINE_LOOP):pe.setMode(O.LINE_STRIP)}else V.isPoints?pe.setMode(O.POINTS):V.isSprite&&pe.setMode(O.TRIANGLES);if(V.isBatchedMesh)if(be.get("WEBGL_multi_draw"))pe.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let rn=V._multiDrawStarts,bt=V._multiDrawCounts,dn=V._multiDrawCount,re=yt?A.get(yt).bytesPerElement:1,Ws=Lt.get(z).currentProgram.getUniforms();for(let on=0;on<dn;on++)Ws.setValue(O,"_gl_DrawID",on),pe.render(rn[on]/re,bt[on])}else if(V.isInstancedMesh)pe.renderInstances(St,Ue,V.count);else if(q.isInstancedBufferGeometry){let rn=q._maxInstanceCount!==void 0?q._maxInstanceCount:1/0,bt=Math.min(q.instanceCount,rn);pe.renderInstances(St,Ue,bt)}else pe.render(St,Ue)};function qf(E,U,q,z){N!==null&&E.isNodeMaterial&&N.setObject(z,E),Me===!0&&J.setState(E,q,!1),E.transparent===!0&&E.side===Si&&E.forceSinglePass===!1?(E.side=xn,E.needsUpdate=!0,vo(E,U,z),E.side=vs,E.needsUpdate=!0,vo(E,U,z),E.side=Si):vo(E,U,z)}this.compile=function(E,U,q=null){q===null&&(q=E),N!==null&&N.renderStart(E,U,q),w=Z.get(q),w.init(U),S.push(w),q.traverseVisible(function(V){V.isLight&&V.layers.test(U.layers)&&(w.pushLight(V),V.castShadow&&w.pushShadow(V))}),E!==q&&E.traverseVisible(function(V){V.isLight&&V.layers.test(U.layers)&&(w.pushLight(V),V.castShadow&&w.pushShadow(V))}),w.setupLights(),N!==null&&N.updateLights(w.state.lightsArray),se=this.localClippingEnabled,Me=J.init(this.clippingPlanes,se),Me===!0&&J.setGlobalState(this.clippingPlanes,U),N!==null&&ct.render(w.state.shadowsArray,q,U);let z=new Set;return E.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let dt=V.material;if(dt)if(Array.isArray(dt))for(let Mt=0;Mt<dt.length;Mt++){let ht=dt[Mt];qf(ht,q,U,V),z.add(ht)}else qf(dt,q,U,V),z.add(dt)}),w=S.pop(),N!==null&&N.renderEnd(),z},this.compileAsync=function(E,U,q=null){let z=this.compile(E,U,q);return new Promise(V=>{function dt(){if(z.forEach(function(Mt){let yt=Lt.get(Mt).currentProgram;(yt===void 0||yt.isReady())&&z.delete(Mt)}),z.size===0){V(E);return}setTimeout(dt,10)}be.get("KHR_parallel_shader_compile")!==null?dt():setTimeout(dt,10)})};let ou=null;function K_(E){ou&&ou(E)}function Xf(){Hs.stop()}function $f(){Hs.start()}let Hs=new Wm;Hs.setAnimationLoop(K_),typeof self<"u"&&Hs.setContext(self),this.setAnimationLoop=function(E){ou=E,nt.setAnimationLoop(E),E===null?Hs.stop():Hs.start()},nt.addEventListener("sessionstart",Xf),nt.addEventListener("sessionend",$f),this.render=function(E,U){if(U!==void 0&&U.isCamera!==!0){Ut("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;N!==null&&N.renderStart(E,U);let q=nt.enabled===!0&&nt.isPresenting===!0,z=I!==null&&(j===null||q)&&I.begin(T,j);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),U.parent===null&&U.matrixWorldAutoUpdate===!0&&U.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(U),U=nt.getCamera()),E.isScene===!0&&E.onBeforeRender(T,E,U,j),w=Z.get(E,S.length),w.init(U),w.state.textureUnits=Bt.getTextureUnits(),S.push(w),ge.multiplyMatrices(U.projectionMatrix,U.matrixWorldInverse),U.isArrayCamera?Te.setFromArrayCamera(U):Vt.setFromProjectionMatrix(ge,qn,U.reversedDepth),se=this.localClippingEnabled,Me=J.init(this.clippingPlanes,se),b=ut.get(E,y.length),b.init(),y.push(b),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){let Mt=T.xr.getDepthSensingMesh();Mt!==null&&au(Mt,U,-1/0,T.sortObjects)}au(E,U,0,T.sortObjects),b.finish(),N!==null&&N.updateLights(w.state.lightsArray),T.sortObjects===!0&&b.sort(Dt,me),Gn=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Gn&&D.addToRenderList(b,E),this.info.autoReset===!0&&this.info.reset(),Me===!0&&J.beginShadows();let V=w.state.shadowsArray;if(ct.render(V,E,U),Me===!0&&J.endShadows(),(z&&I.hasRenderPass())===!1){let Mt=b.opaque,ht=b.transmissive;if(w.setupLights(),U.isArrayCamera){let yt=U.cameras;if(ht.length>0)for(let Et=0,kt=yt.length;Et<kt;Et++){let Jt=yt[Et];Zf(Mt,ht,E,Jt)}Gn&&D.render(E);for(let Et=0,kt=yt.length;Et<kt;Et++){let Jt=yt[Et];Yf(b,E,Jt,Jt.viewport)}}else ht.length>0&&Zf(Mt,ht,E,U),Gn&&D.render(E),Yf(b,E,U)}j!==null&&H===0&&(Bt.updateMultisampleRenderTarget(j),Bt.updateRenderTargetMipmap(j)),z&&I.end(T),E.isScene===!0&&E.onAfterRender(T,E,U),at.resetDefaultState(),W=-1,Y=null,S.pop(),S.length>0?(w=S[S.length-1],Bt.setTextureUnits(w.state.textureUnits),Me===!0&&J.setGlobalState(T.clippingPlanes,w.state.camera)):w=null,y.pop(),y.length>0?b=y[y.length-1]:b=null,N!==null&&N.renderEnd()};function au(E,U,q,z){if(E.visible===!1)return;if(E.layers.test(U.layers)){if(E.isGroup)q=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(U);else if(E.isLight)w.pushLight(E),E.castShadow&&w.pushShadow(E);else if(E.isSprite){let Mt=U.isArrayCamera?Te:Vt;if(!E.frustumCulled||E.intersectsFrustum(Mt)){z&&Le.setFromMatrixPosition(E.matrixWorld).applyMatrix4(ge);let ht=et.update(E),yt=E.material;yt.visible&&b.push(E,ht,yt,q,Le.z,null,U)}}else if(E.isMesh||E.isLine||E.isPoints){let Mt=U.isArrayCamera?Te:Vt;if(!E.frustumCulled||E.intersectsFrustum(Mt)){let ht=et.update(E),yt=E.material;if(z&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Le.copy(E.boundingSphere.center)):(ht.boundingSphere===null&&ht.computeBoundingSphere(),Le.copy(ht.boundingSphere.center)),Le.applyMatrix4(E.matrixWorld).applyMatrix4(ge)),Array.isArray(yt)){let Et=ht.groups;for(let kt=0,Jt=Et.length;kt<Jt;kt++){let St=Et[kt],Kt=yt[St.materialIndex];Kt&&Kt.visible&&b.push(E,ht,Kt,q,Le.z,St,U)}}else yt.visible&&b.push(E,ht,yt,q,Le.z,null,U)}}}let dt=E.children;for(let Mt=0,ht=dt.length;Mt<ht;Mt++)au(dt[Mt],U,q,z)}function Yf(E,U,q,z){let{opaque:V,transmissive:dt,transparent:Mt}=E;w.setupLightsView(q),Me===!0&&J.setGlobalState(T.clippingPlanes,q),z&&mt.viewport(tt.copy(z)),V.length>0&&Xa(V,U,q),dt.length>0&&Xa(dt,U,q),Mt.length>0&&Xa(Mt,U,q),mt.buffers.depth.setTest(!0),mt.buffers.depth.setMask(!0),mt.buffers.color.setMask(!0),mt.setPolygonOffset(!1)}function Zf(E,U,q,z){if((q.isScene===!0?q.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[z.id]===void 0){let St=be.has("EXT_color_buffer_half_float")||be.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[z.id]=new Nn(1,1,{generateMipmaps:!0,type:St?ci:An,minFilter:qi,samples:Math.max(4,we.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:jt.workingColorSpace})}let dt=w.state.transmissionRenderTarget[z.id],Mt=z.viewport||tt;dt.setSize(Mt.z*T.transmissionResolutionScale,Mt.w*T.transmissionResolutionScale);let ht=T.getRenderTarget(),yt=T.getActiveCubeFace(),Et=T.getActiveMipmapLevel();T.setRenderTarget(dt),T.getClearColor(X),rt=T.getClearAlpha(),rt<1&&T.setClearColor(16777215,.5),T.clear(),Gn&&D.render(q);let kt=T.toneMapping;T.toneMapping=bi;let Jt=z.viewport;if(z.viewport!==void 0&&(z.viewport=void 0),w.setupLightsView(z),Me===!0&&J.setGlobalState(T.clippingPlanes,z),Xa(E,q,z),Bt.updateMultisampleRenderTarget(dt),Bt.updateRenderTargetMipmap(dt),be.has("WEBGL_multisampled_render_to_texture")===!1){let St=!1;for(let Kt=0,Ue=U.length;Kt<Ue;Kt++){let xe=U[Kt],{object:pe,geometry:rn,material:bt,group:dn}=xe;if(bt.side===Si&&pe.layers.test(z.layers)){let re=bt.side;bt.side=xn,bt.needsUpdate=!0,Jf(pe,q,z,rn,bt,dn),bt.side=re,bt.needsUpdate=!0,St=!0}}St===!0&&(Bt.updateMultisampleRenderTarget(dt),Bt.updateRenderTargetMipmap(dt))}T.setRenderTarget(ht,yt,Et),T.setClearColor(X,rt),Jt!==void 0&&(z.viewport=Jt),T.toneMapping=kt}function Xa(E,U,q){let z=U.isScene===!0?U.overrideMaterial:null;for(let V=0,dt=E.length;V<dt;V++){let Mt=E[V],{object:ht,geometry:yt,group:Et}=Mt,kt=Mt.material;kt.allowOverride===!0&&z!==null&&(kt=z),ht.layers.test(q.layers)&&Jf(ht,U,q,yt,kt,Et)}}function Jf(E,U,q,z,V,dt){N!==null&&V.isNodeMaterial&&N.setObject(E,V),E.onBeforeRender(T,U,q,z,V,dt),E.modelViewMatrix.multiplyMatrices(q.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),V.onBeforeRender(T,U,q,z,E,dt),V.transparent===!0&&V.side===Si&&V.forceSinglePass===!1?(V.side=xn,V.needsUpdate=!0,T.renderBufferDirect(q,U,z,V,E,dt),V.side=vs,V.needsUpdate=!0,T.renderBufferDirect(q,U,z,V,E,dt),V.side=Si):T.renderBufferDirect(q,U,z,V,E,dt),E.onAfterRender(T,U,q,z,V,dt)}function Kf(E){let U=0;for(let q of E)q.texture!==null&&U++;return U}function vo(E,U,q){U.isScene!==!0&&(U=un);let z=Lt.get(E),V=w.state.lights,dt=w.state.shadowsArray,Mt=V.state.version,ht=Q.getParameters(E,V.state,dt,U,q,w.state.lightProbeGridArray),yt=Q.getProgramCacheKey(ht),Et=z.programs;z.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?U.environment:null,z.fog=U.fog;let kt=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;z.envMap=R.get(E.envMap||z.environment,kt),z.envMapRotation=z.environment!==null&&E.envMap===null?U.environmentRotation:E.envMapRotation,Et===void 0&&(E.addEventListener("dispose",le),Et=new Map,z.programs=Et,z.programVariants=new Map);let Jt=Et.get(yt);if(Jt!==void 0){if(z.currentProgram===Jt&&z.lightsStateVersion===Mt)return Qf(E,ht),Jt}else ht.uniforms=Q.getUniforms(E),N!==null&&E.isNodeMaterial&&N.build(E,q,ht),E.onBeforeCompile(ht,T),Jt=Q.acquireProgram(ht,yt),Et.set(yt,Jt),z.uniforms=ht.uniforms;let St=z.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(St.clippingPlanes=J.uniform),Qf(E,ht),z.needsLights=ey(E),z.lightsStateVersion=Mt,z.needsLights&&(St.ambientLightColor.value=V.state.ambient,St.lightProbe.value=V.state.probe,St.sunLights.value=V.state.sun,St.sunLightShadows.value=V.state.sunShadow,St.directionalLights.value=V.state.directional,St.directionalLightShadows.value=V.state.directionalShadow,St.spotLights.value=V.state.spot,St.spotLightShadows.value=V.state.spotShadow,St.rectAreaLights.value=V.state.rectArea,St.ltc_1.value=V.state.rectAreaLTC1,St.ltc_2.value=V.state.rectAreaLTC2,St.pointLights.value=V.state.point,St.pointLightShadows.value=V.state.pointShadow,St.hemisphereLights.value=V.state.hemi,St.sunShadowMatrix.value=V.state.sunShadowMatrix,St.sunShadowCascade.value=V.state.sunShadowCascade,St.directionalShadowMatrix.value=V.state.directionalShadowMatrix,St.spotLightMatrix.value=V.state.spotLightMatrix,St.spotLightMap.value=V.state.spotLightMap,St.pointShadowMatrix.value=V.state.pointShadowMatrix),z.numLightProbeGrids=Kf(w.state.lightProbeGridArray),z.currentProgram=Jt,z.uniformsList=null,Jt}function j_(E,U,q,z,V){let dt=Lt.get(E),Mt=dt.currentProgram.id+","+z+","+V,ht=dt.programVariants.get(Mt);return ht===void 0?(ht=vo(E,U,q),dt.programVariants.set(Mt,ht)):(dt.currentProgram=ht,dt.uniformsList=null,dt.outputColorSpace=z,dt.toneMapping=V),ht}function jf(E){if(E.uniformsList===null){let U=E.currentProgram.getUniforms();E.uniformsList=qr.seqWithValue(U.seq,E.uniforms)}return E.uniformsList}function Qf(E,U){let q=Lt.get(E);q.outputColorSpace=U.outputColorSpace,q.batching=U.batching,q.batchingColor=U.batchingColor,q.instancing=U.instancing,q.instancingColor=U.instancingColor,q.instancingMorph=U.instancingMorph,q.skinning=U.skinning,q.morphTargets=U.morphTargets,q.morphNormals=U.morphNormals,q.morphColors=U.morphColors,q.morphTargetsCount=U.morphTargetsCount,q.numClippingPlanes=U.numClippingPlanes,q.numIntersection=U.numClipIntersection,q.vertexAlphas=U.vertexAlphas,q.vertexTangents=U.vertexTangents,q.toneMapping=U.toneMapping}function Q_(E,U,q,z,V){U.isScene!==!0&&(U=un),Bt.resetTextureUnits();let dt=U.fog,Mt=z.isMeshStandardMaterial||z.isMeshLambertMaterial||z.isMeshPhongMaterial?U.environment:null,ht=j===null?T.outputColorSpace:j.isXRRenderTarget===!0?j.texture.colorSpace:jt.workingColorSpace,yt=z.isMeshStandardMaterial||z.isMeshLambertMaterial&&!z.envMap||z.isMeshPhongMaterial&&!z.envMap,Et=R.get(z.envMap||Mt,yt),kt=z.vertexColors===!0&&!!q.attributes.color&&q.attributes.color.itemSize===4,Jt=!!q.attributes.tangent&&(!!z.normalMap||z.anisotropy>0),St=!!q.morphAttributes.position,Kt=!!q.morphAttributes.normal,Ue=!!q.morphAttributes.color,xe=bi;z.toneMapped&&(j===null||j.isXRRenderTarget===!0)&&(xe=T.toneMapping);let pe=q.morphAttributes.position||q.morphAttributes.normal||q.morphAttributes.color,rn=pe!==void 0?pe.length:0,bt=Lt.get(z),dn=w.state.lights;if(Me===!0&&(se===!0||E!==Y)){let Re=E===Y&&z.id===W;J.setState(z,E,Re)}let re=!1,Ws=!1;z.version===bt.__version?bt.needsLights&&bt.lightsStateVersion!==dn.state.version||V.isBatchedMesh&&bt.batching===!1||!V.isBatchedMesh&&bt.batching===!0||V.isBatchedMesh&&bt.batchingColor===!0&&V._colorsTexture===null||V.isBatchedMesh&&bt.batchingColor===!1&&V._colorsTexture!==null||V.isInstancedMesh&&bt.instancing===!1||!V.isInstancedMesh&&bt.instancing===!0||V.isSkinnedMesh&&bt.skinning===!1||!V.isSkinnedMesh&&bt.skinning===!0||V.isInstancedMesh&&bt.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&bt.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&bt.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&bt.instancingMorph===!1&&V.morphTexture!==null||bt.envMap!==Et||z.fog===!0&&bt.fog!==dt||bt.numClippingPlanes!==void 0&&(bt.numClippingPlanes!==J.numPlanes||bt.numIntersection!==J.numIntersection)||bt.vertexAlphas!==kt||bt.vertexTangents!==Jt||bt.morphTargets!==St||bt.morphNormals!==Kt||bt.morphColors!==Ue||bt.morphTargetsCount!==rn||bt.numLightProbeGrids!==Kf(w.state.lightProbeGridArray)?re=!0:(bt.outputColorSpace!==ht||bt.toneMapping!==xe)&&(Ws=!0):(re=!0,bt.__version=z.version);let on=bt.currentProgram;(re===!0||Ws===!0)&&(on=Ws===!0?j_(z,U,V,ht,xe):vo(z,U,V),N&&z.isNodeMaterial&&N.onUpdateProgram(z,on,bt));let $a=!1,os=!1,qs=!1,ne=on.getUniforms(),Ke=bt.uniforms;if(mt.useProgram(on.program)&&($a=!0,os=!0,qs=!0),z.id!==W&&(W=z.id,os=!0),$a||Y!==E){mt.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ne.setValue(O,"projectionMatrix",E.projectionMatrix),ne.setValue(O,"viewMatrix",E.matrixWorldInverse);let qe=ne.map.cameraPosition;qe!==void 0&&qe.setValue(O,Cn.setFromMatrixPosition(E.matrixWorld)),we.logarithmicDepthBuffer&&ne.setValue(O,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(z.isMeshPhongMaterial||z.isMeshToonMaterial||z.isMeshLambertMaterial||z.isMeshBasicMaterial||z.isMeshStandardMaterial||z.isShaderMaterial)&&ne.setValue(O,"isOrthographic",E.isOrthographicCamera===!0),Y!==E&&(Y=E,os=!0,qs=!0)}if(bt.needsLights&&(dn.state.sunShadowMap.length>0&&ne.setValue(O,"sunShadowMap",dn.state.sunShadowMap,Bt),dn.state.directionalShadowMap.length>0&&ne.setValue(O,"directionalShadowMap",dn.state.directionalShadowMap,Bt),dn.state.spotShadowMap.length>0&&ne.setValue(O,"spotShadowMap",dn.state.spotShadowMap,Bt),dn.state.pointShadowMap.length>0&&ne.setValue(O,"pointShadowMap",dn.state.pointShadowMap,Bt)),V.isSkinnedMesh){ne.setOptional(O,V,"bindMatrix"),ne.setOptional(O,V,"bindMatrixInverse");let Re=V.skeleton;Re&&(Re.boneTexture===null&&Re.computeBoneTexture(),ne.setValue(O,"boneTexture",Re.boneTexture,Bt))}V.isBatchedMesh&&(ne.setOptional(O,V,"batchingTexture"),ne.setValue(O,"batchingTexture",V._matricesTexture,Bt),ne.setOptional(O,V,"batchingIdTexture"),ne.setValue(O,"batchingIdTexture",V._indirectTexture,Bt),ne.setOptional(O,V,"batchingColorTexture"),V._colorsTexture!==null&&ne.setValue(O,"batchingColorTexture",V._colorsTexture,Bt));let ti=q.morphAttributes;if((ti.position!==void 0||ti.normal!==void 0||ti.color!==void 0)&&K.update(V,q,on),(os||bt.receiveShadow!==V.receiveShadow)&&(bt.receiveShadow=V.receiveShadow,ne.setValue(O,"receiveShadow",V.receiveShadow)),(z.isMeshStandardMaterial||z.isMeshLambertMaterial||z.isMeshPhongMaterial)&&z.envMap===null&&U.environment!==null&&(Ke.envMapIntensity.value=U.environmentIntensity),Ke.dfgLUT!==void 0&&(Ke.dfgLUT.value=q1()),os){if(ne.setValue(O,"toneMappingExposure",T.toneMappingExposure),bt.needsLights&&ty(Ke,qs),dt&&z.fog===!0&&ot.refreshFogUniforms(Ke,dt),ot.refreshMaterialUniforms(Ke,z,pt,At,w.state.transmissionRenderTarget[E.id]),bt.needsLights&&bt.numLightProbeGrids>0){let Re=v,qe=0;for(let Di of w.state.lightProbeGridArray)Di.texture!==null&&(Re.textures[qe]=Di.texture,Re.min[qe]=Di.boundingBox.min,Re.max[qe]=Di.boundingBox.max,Re.resolution[qe]=Di.resolution,qe++);for(let Di in Re)Re[Di].length=qe;Ke.probesSH.value=Re.textures,Ke.probesMin.value=Re.min,Ke.probesMax.value=Re.max,Ke.probesResolution.value=Re.resolution}qr.upload(O,jf(bt),Ke,Bt)}if(z.isShaderMaterial&&z.uniformsNeedUpdate===!0&&(qr.upload(O,jf(bt),Ke,Bt),z.uniformsNeedUpdate=!1),z.isSpriteMaterial&&ne.setValue(O,"center",V.center),ne.setValue(O,"modelViewMatrix",V.modelViewMatrix),ne.setValue(O,"normalMatrix",V.normalMatrix),ne.setValue(O,"modelMatrix",V.matrixWorld),z.uniformsGroups!==void 0){let Re=z.uniformsGroups;for(let qe=0,Di=Re.length;qe<Di;qe++){let ep=Re[qe];Ct.update(ep,on),Ct.bind(ep,on)}}return on}function ty(E,U){E.ambientLightColor.needsUpdate=U,E.lightProbe.needsUpdate=U,E.sunLights.needsUpdate=U,E.sunLightShadows.needsUpdate=U,E.directionalLights.needsUpdate=U,E.directionalLightShadows.needsUpdate=U,E.pointLights.needsUpdate=U,E.pointLightShadows.needsUpdate=U,E.spotLights.needsUpdate=U,E.spotLightShadows.needsUpdate=U,E.rectAreaLights.needsUpdate=U,E.hemisphereLights.needsUpdate=U}function ey(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return G},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return j},this.setRenderTargetTextures=function(E,U,q){let z=Lt.get(E);z.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,z.__autoAllocateDepthBuffer===!1&&(z.__useRenderToTexture=!1),Lt.get(E.texture).__webglTexture=U,Lt.get(E.depthTexture).__webglTexture=z.__autoAllocateDepthBuffer?void 0:q,z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,U){let q=Lt.get(E);q.__webglFramebuffer=U,q.__useDefaultFramebuffer=U===void 0},this.setRenderTarget=function(E,U=0,q=0){j=E,G=U,H=q;let z=null,V=!1,dt=!1;if(E){let ht=Lt.get(E);if(ht.__useDefaultFramebuffer!==void 0){mt.bindFramebuffer(O.FRAMEBUFFER,ht.__webglFramebuffer),tt.copy(E.viewport),gt.copy(E.scissor),wt=E.scissorTest,mt.viewport(tt),mt.scissor(gt),mt.setScissorTest(wt),W=-1;return}else if(ht.__webglFramebuffer===void 0)Bt.setupRenderTarget(E);else if(ht.__hasExternalTextures)Bt.rebindTextures(E,Lt.get(E.texture).__webglTexture,Lt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let kt=E.depthTexture;if(ht.__boundDepthTexture!==kt){if(kt!==null&&Lt.has(kt)&&(E.width!==kt.image.width||E.height!==kt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Bt.setupDepthRenderbuffer(E)}}let yt=E.texture;(yt.isData3DTexture||yt.isDataArrayTexture||yt.isCompressedArrayTexture)&&(dt=!0);let Et=Lt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Et[U])?z=Et[U][q]:z=Et[U],V=!0):E.samples>0&&Bt.useMultisampledRTT(E)===!1?z=Lt.get(E).__webglMultisampledFramebuffer:Array.isArray(Et)?z=Et[q]:z=Et,tt.copy(E.viewport),gt.copy(E.scissor),wt=E.scissorTest}else tt.copy(Rt).multiplyScalar(pt).floor(),gt.copy(Zt).multiplyScalar(pt).floor(),wt=te;if(q!==0&&(z=F),mt.bindFramebuffer(O.FRAMEBUFFER,z)&&mt.drawBuffers(E,z),mt.viewport(tt),mt.scissor(gt),mt.setScissorTest(wt),V){let ht=Lt.get(E.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+U,ht.__webglTexture,q)}else if(dt){let ht=U;for(let yt=0;yt<E.textures.length;yt++){let Et=Lt.get(E.textures[yt]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+yt,Et.__webglTexture,q,ht)}}else if(E!==null&&q!==0){let ht=Lt.get(E.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ht.__webglTexture,q)}W=-1};function tp(E){let U=Lt.get(E);return(U.__readFormat!==E.format||U.__readType!==E.type)&&(U.__readFormat=E.format,U.__readType=E.type,U.__formatReadable=we.textureFormatReadable(E.format),U.__typeReadable=we.textureTypeReadable(E.type)),U}this.readRenderTargetPixels=function(E,U,q,z,V,dt,Mt,ht=0){if(!(E&&E.isWebGLRenderTarget)){Ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let yt=Lt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Mt!==void 0&&(yt=yt[Mt],Array.isArray(yt)&&(yt=yt[0])),yt){mt.bindFramebuffer(O.FRAMEBUFFER,yt);try{let Et=E.textures[ht],kt=Et.format,Jt=Et.type;E.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ht);let St=tp(Et);if(St.__formatReadable===!1){Ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(St.__typeReadable===!1){Ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}U>=0&&U<=E.width-z&&q>=0&&q<=E.height-V&&O.readPixels(U,q,z,V,it.convert(kt),it.convert(Jt),dt)}finally{let Et=j!==null?Lt.get(j).__webglFramebuffer:null;mt.bindFramebuffer(O.FRAMEBUFFER,Et)}}},this.readRenderTargetPixelsAsync=async function(E,U,q,z,V,dt,Mt,ht=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let yt=Lt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Mt!==void 0&&(yt=yt[Mt],Array.isArray(yt)&&(yt=yt[0])),yt)if(U>=0&&U<=E.width-z&&q>=0&&q<=E.height-V){mt.bindFramebuffer(O.FRAMEBUFFER,yt);let Et=E.textures[ht],kt=Et.format,Jt=Et.type;E.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ht);let St=tp(Et);if(St.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(St.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Kt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,Kt),O.bufferData(O.PIXEL_PACK_BUFFER,dt.byteLength,O.STREAM_READ),O.readPixels(U,q,z,V,it.convert(kt),it.convert(Jt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Ue=j!==null?Lt.get(j).__webglFramebuffer:null;mt.bindFramebuffer(O.FRAMEBUFFER,Ue);let xe=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await _m(O,xe,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,Kt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,dt),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(Kt),O.deleteSync(xe),dt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,U=null,q=0){let z=Math.pow(2,-q),V=Math.floor(E.image.width*z),dt=Math.floor(E.image.height*z),Mt=U!==null?U.x:0,ht=U!==null?U.y:0;Bt.setTexture2D(E,0),O.copyTexSubImage2D(O.TEXTURE_2D,q,0,0,Mt,ht,V,dt),mt.unbindTexture()},this.copyTextureToTexture=function(E,U,q=null,z=null,V=0,dt=0){let Mt,ht,yt,Et,kt,Jt,St,Kt,Ue,xe=E.isCompressedTexture?E.mipmaps[dt]:E.image;if(q!==null)Mt=q.max.x-q.min.x,ht=q.max.y-q.min.y,yt=q.isBox3?q.max.z-q.min.z:1,Et=q.min.x,kt=q.min.y,Jt=q.isBox3?q.min.z:0;else{let ne=Math.pow(2,-V);Mt=Math.floor(xe.width*ne),ht=Math.floor(xe.height*ne),E.isDataArrayTexture?yt=xe.depth:E.isData3DTexture?yt=Math.floor(xe.depth*ne):yt=1,Et=0,kt=0,Jt=0}z!==null?(St=z.x,Kt=z.y,Ue=z.z):(St=0,Kt=0,Ue=0);let pe=it.convert(U.format),rn=it.convert(U.type),bt;U.isData3DTexture?(Bt.setTexture3D(U,0),bt=O.TEXTURE_3D):U.isDataArrayTexture||U.isCompressedArrayTexture?(Bt.setTexture2DArray(U,0),bt=O.TEXTURE_2D_ARRAY):(Bt.setTexture2D(U,0),bt=O.TEXTURE_2D),mt.activeTexture(O.TEXTURE0),mt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,U.flipY),mt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,U.premultiplyAlpha),mt.pixelStorei(O.UNPACK_ALIGNMENT,U.unpackAlignment);let dn=mt.getParameter(O.UNPACK_ROW_LENGTH),re=mt.getParameter(O.UNPACK_IMAGE_HEIGHT),Ws=mt.getParameter(O.UNPACK_SKIP_PIXELS),on=mt.getParameter(O.UNPACK_SKIP_ROWS),$a=mt.getParameter(O.UNPACK_SKIP_IMAGES);mt.pixelStorei(O.UNPACK_ROW_LENGTH,xe.width),mt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,xe.height),mt.pixelStorei(O.UNPACK_SKIP_PIXELS,Et),mt.pixelStorei(O.UNPACK_SKIP_ROWS,kt),mt.pixelStorei(O.UNPACK_SKIP_IMAGES,Jt);let os=E.isDataArrayTexture||E.isData3DTexture,qs=U.isDataArrayTexture||U.isData3DTexture;if(E.isDepthTexture){let ne=Lt.get(E),Ke=Lt.get(U),ti=Lt.get(ne.__renderTarget),Re=Lt.get(Ke.__renderTarget);mt.bindFramebuffer(O.READ_FRAMEBUFFER,ti.__webglFramebuffer),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,Re.__webglFramebuffer);for(let qe=0;qe<yt;qe++)os&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Lt.get(E).__webglTexture,V,Jt+qe),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Lt.get(U).__webglTexture,dt,Ue+qe)),O.blitFramebuffer(Et,kt,Et+Mt,kt+ht,St,Kt,St+Mt,Kt+ht,O.DEPTH_BUFFER_BIT,O.NEAREST);mt.bindFramebuffer(O.READ_FRAMEBUFFER,null),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(V!==0||E.isRenderTargetTexture||Lt.has(E)){let ne=Lt.get(E),Ke=Lt.get(U);mt.bindFramebuffer(O.READ_FRAMEBUFFER,P),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,B);for(let ti=0;ti<yt;ti++)os?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ne.__webglTexture,V,Jt+ti):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ne.__webglTexture,V),qs?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ke.__webglTexture,dt,Ue+ti):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ke.__webglTexture,dt),V!==0?O.blitFramebuffer(Et,kt,Et+Mt,kt+ht,St,Kt,St+Mt,Kt+ht,O.COLOR_BUFFER_BIT,O.NEAREST):qs?O.copyTexSubImage3D(bt,dt,St,Kt,Ue+ti,Et,kt,Mt,ht):O.copyTexSubImage2D(bt,dt,St,Kt,Et,kt,Mt,ht);mt.bindFramebuffer(O.READ_FRAMEBUFFER,null),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else qs?E.isDataTexture||E.isData3DTexture?O.texSubImage3D(bt,dt,St,Kt,Ue,Mt,ht,yt,pe,rn,xe.data):U.isCompressedArrayTexture?O.compressedTexSubImage3D(bt,dt,St,Kt,Ue,Mt,ht,yt,pe,xe.data):O.texSubImage3D(bt,dt,St,Kt,Ue,Mt,ht,yt,pe,rn,xe):E.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,dt,St,Kt,Mt,ht,pe,rn,xe.data):E.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,dt,St,Kt,xe.width,xe.height,pe,xe.data):O.texSubImage2D(O.TEXTURE_2D,dt,St,Kt,Mt,ht,pe,rn,xe);mt.pixelStorei(O.UNPACK_ROW_LENGTH,dn),mt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,re),mt.pixelStorei(O.UNPACK_SKIP_PIXELS,Ws),mt.pixelStorei(O.UNPACK_SKIP_ROWS,on),mt.pixelStorei(O.UNPACK_SKIP_IMAGES,$a),dt===0&&U.generateMipmaps===!0&&U.mipmapsAutoUpdate===!0&&O.generateMipmap(bt),mt.unbindTexture()},this.initRenderTarget=function(E){Lt.get(E).__webglFramebuffer===void 0&&Bt.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Bt.setTextureCube(E,0):E.isData3DTexture?Bt.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Bt.setTexture2DArray(E,0):Bt.setTexture2D(E,0),mt.unbindTexture()},this.resetState=function(){G=0,H=0,j=null,mt.reset(),at.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return qn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=jt._getDrawingBufferColorSpace(t),e.unpackColorSpace=jt._getUnpackColorSpace()}};var th=26,jl=.1,eg=1.55,[X1,$1]=[.4,6],Y1=5,Ql=class{constructor(t){this.azimuth=.52,this.elevation=.38,this.zoom=1,this.onChange=t,this.taken=null,document.addEventListener("pointerdown",e=>e.target!==this.taken&&this.letGo(),{capture:!0}),document.addEventListener("keydown",e=>e.key==="Escape"&&this.letGo())}take(t){this.letGo(),this.taken=t,t.parentElement.classList.add("held")}letGo(){this.taken?.parentElement?.classList.remove("held"),this.taken=null}turn(t,e){this.azimuth-=t,this.elevation=Math.min(eg,Math.max(-eg,this.elevation+e)),this.onChange()}closer(t){this.zoom=Math.min($1,Math.max(X1,this.zoom*t)),this.onChange()}place(t,e,n,s){let r=th*Math.PI/360,o=Math.min(r,Math.atan(Math.tan(r)*s)),a=n/Math.sin(o)/this.zoom,[c,l]=[Math.cos(this.elevation),Math.sin(this.elevation)];t.position.set(c*Math.cos(this.azimuth),c*Math.sin(this.azimuth),l).multiplyScalar(a).add(e),t.up.set(0,0,1),t.aspect=s,t.near=Math.max(a-4*n,a/100),t.far=a+8*n,t.lookAt(e),t.updateProjectionMatrix(),t.updateMatrixWorld()}listen(t){let e=new Map,n=null,s=()=>{let[r,o]=[...e.values()];return Math.hypot(r[0]-o[0],r[1]-o[1])};t.addEventListener("pointerdown",r=>{r.button===0&&(n=[r.clientX,r.clientY],e.set(r.pointerId,n),t.setPointerCapture(r.pointerId))}),t.addEventListener("mousedown",r=>r.preventDefault()),t.addEventListener("pointermove",r=>{let o=e.get(r.pointerId);if(!o)return;let a=e.size===2?s():0;e.set(r.pointerId,[r.clientX,r.clientY]),e.size===2?this.closer(s()/Math.max(a,1)):e.size===1&&this.turn((r.clientX-o[0])*.008,(r.clientY-o[1])*.008)});for(let r of["pointerup","pointercancel"])t.addEventListener(r,o=>e.delete(o.pointerId));t.addEventListener("pointerup",r=>{n&&Math.hypot(r.clientX-n[0],r.clientY-n[1])<Y1&&r.pointerType==="mouse"&&this.take(t),n=null}),t.addEventListener("wheel",r=>this.wheel(r,t),{passive:!1})}wheel(t,e){this.taken!==e&&!t.ctrlKey||(t.preventDefault(),this.closer(Math.exp(-.002*(t.deltaY||t.deltaX))))}key(t){let e={ArrowLeft:[jl,0],ArrowRight:[-jl,0],ArrowUp:[0,jl],ArrowDown:[0,-jl]};if(e[t])this.turn(...e[t]);else if(t==="PageUp")this.closer(1.15);else if(t==="PageDown")this.closer(1/1.15);else return!1;return!0}},ng=()=>new pn(th,1,.1,100),Rd=new C(0,0,0);var ig=new Map,bs=({key:i,usual:t=!0})=>ig.get(i)??t,sg=(i,t)=>ig.set(i,t),$r=(i,t,e,n=!0)=>({key:i,color:t,text:e,usual:n});var eh=i=>document.getElementById(i);function Cd({name:i,title:t=i,summary:e,notes:n}){eh("name").textContent=t,eh("summary").textContent=e,eh("notes").replaceChildren(...n.map(s=>ws("li",s)))}function ws(i,t,e=""){let n=document.createElement(i);return n.textContent=t,e&&(n.className=e),n}function rg(i,t){let e=document.createElement("figure");e.className=i.flat?"panel flat":"panel";let n=document.createElement("canvas");n.setAttribute("role","img"),i.flat||(n.tabIndex=0,t.listen(n),n.addEventListener("keydown",r=>{t.key(r.key)&&r.preventDefault()}));let s=document.createElement("button");return s.type="button",s.className="enlarge",e.append(n,document.createElement("figcaption"),s),eh("panels").append(e),n}function og(i,t,e,n=()=>{}){let s=i.nextElementSibling,r=t.title==="The body in space"&&e.up==="L"?"L points up":"",o=ws("span",[t.words,r].filter(Boolean).join("; "),"words"),a=ws("span","","legend");for(let h of t.legend)a.append(Z1(h,n));let c=ws("span","","heading");c.append(ws("strong",t.title),o),s.replaceChildren(c,a),s.nextElementSibling.setAttribute("aria-label",`Make large: ${t.title}`);let l=t.flat?".":". Arrow keys turn the view, page up and down bring it closer.";i.setAttribute("aria-label",[t.title,t.words].filter(Boolean).join(": ")+l)}function Z1(i,t){let e=document.createElement("i");if(i.color&&(e.style.background=i.color),i.press){let s=ws("button",i.text);return s.type="button",s.setAttribute("aria-pressed",String(i.pressed())),s.addEventListener("click",()=>{i.press(),s.setAttribute("aria-pressed",String(i.pressed())),t()}),s}let n=document.createElement(i.key?"label":"span");if(i.key){let s=document.createElement("input");Object.assign(s,{type:"checkbox",checked:bs(i)}),s.dataset.part=i.key,s.setAttribute("aria-label",`show ${i.text}`),s.addEventListener("change",()=>{sg(i.key,s.checked),t()}),n.append(s)}return n.append(e,i.text),n}function ag(i,t){i.replaceChildren(...t.map(([e,n])=>{let s=document.createElement("div");return s.append(ws("dt",e),ws("dd",n)),s}))}var nh=class{constructor(t,e,n){this.roots=t,this.onChange=e,this.refuse=n,this.rows=new Map}show(t,e){let n=t.map(({key:s})=>s);if(n.join()!==this.keys){this.keys=n.join();let s=new Map(t.map(a=>[a.key,this.rows.get(a.key)??this.row(a)]));this.rows=s;let r=e.filter(a=>s.has(a)),o=n.filter(a=>!r.includes(a));cg(this.roots.first,r.map(a=>s.get(a).line)),cg(this.roots.more,o.map(a=>s.get(a).line)),this.roots.fold.hidden=!o.length}for(let s of t)this.refresh(s)}row(t){let e=document.createElement("div");e.className=t.choices?"control choice":"control";let n=document.createElement("label"),s=`set-${t.key.replaceAll(".","-")}`;n.htmlFor=s,e.append(n);let r={label:n,line:e};if(t.choices){r.choice=document.createElement("select"),r.choice.id=s;for(let[o,a]of t.choices)r.choice.append(new Option(a,o));r.choice.addEventListener("change",()=>this.onChange(t.key,Number(r.choice.value))),e.append(r.choice)}else r.slider=document.createElement("input"),Object.assign(r.slider,{type:"range",min:0,max:1e3,step:"any"}),r.slider.addEventListener("input",()=>this.onChange(t.key,J1(r.control,Number(r.slider.value)/1e3))),r.slider.addEventListener("change",()=>this.settle()),r.field=document.createElement("input"),Object.assign(r.field,{type:"text",inputMode:"decimal",id:s,autocomplete:"off"}),r.field.addEventListener("change",()=>this.typed(r)),r.unit=document.createElement("span"),e.append(r.field,r.unit,r.slider);return r}refresh(t){let e=this.rows.get(t.key);if(e.label.textContent=t.label,e.choice){e.choice.value=String(t.value);return}let n=e.slider===document.activeElement&&e.slider.matches(":active");e.control=n?{...e.control,value:t.value}:t,e.slider.setAttribute("aria-label",t.label),n||(e.slider.value=String(1e3*K1(t,t.value))),e.slider.style.setProperty("--part",`${100*Number(e.slider.value)/1e3}%`);let s=Id(t.value/(t.si??1));e.slider.setAttribute("aria-valuetext",`${s} ${t.unit}`),document.activeElement!==e.field&&(e.field.value=s),e.unit.textContent=t.unit,e.field.setAttribute("aria-label",`${t.label} [${t.unit}]`),e.field.setCustomValidity(""),e.field.removeAttribute("aria-invalid")}settle(){this.onChange(null)}typed(t){let e=Number(t.field.value.trim().replace(",","."))*(t.control.si??1),{low:n,high:s,log:r,unit:o,si:a=1}=t.control,c=!t.field.value.trim()||!Number.isFinite(e)?"A number is needed.":r&&!(e>0)?"It must be greater than zero.":"",l=t.control.key.startsWith("body.moments")&&(e<n*.999||e>s*1.001),h=c||(l?`No body has this moment with the two others: ${Id(n/a)} to ${Id(s/a)} ${o}.`:"");t.field.setCustomValidity(h),h?(t.field.setAttribute("aria-invalid","true"),t.field.reportValidity(),this.refuse(h)):this.onChange(t.control.key,e)}};function cg(i,t){for(let e of[...i.children])t.includes(e)||e.remove();t.forEach((e,n)=>i.children[n]!==e&&i.insertBefore(e,i.children[n]??null))}function J1({low:i,high:t,log:e,power:n=1},s){return e?i*(t/i)**s:i+(t-i)*s**n}function K1({low:i,high:t,log:e,power:n=1},s){let r=e?Math.log(Math.max(s,Number.MIN_VALUE)/i)/Math.log(t/i):((s-i)/(t-i))**(1/n);return Math.min(1,Math.max(0,Number.isFinite(r)?r:0))}function Id(i){if(i===0)return"0";let t=Math.abs(i);return t>=.001&&t<1e6?String(Number(i.toPrecision(7))):i.toExponential(5)}var Vd={};as(Vd,{asSpec:()=>cA,changed:()=>oA,controls:()=>rA,event:()=>dA,facts:()=>uA,first:()=>nA,from:()=>sA,keys:()=>iA,make:()=>aA,toml:()=>hA,withSpec:()=>lA});var En=[Math.PI,12246467991473532e-32],ya=[.15915494309189535,-9839338337591243e-33],hg=[.6931471805599453,23190468138462996e-33],yn=[0,0],Ne=[1,0],j1=134217729;function Yi(i){let t=j1*i;return t-(t-i)}function Ge(i,t){let e=i+t,n=e-i;return[e,i-(e-n)+(t-n)]}function Zi(i,t){let e=i+t;return[e,t-(e-i)]}function Ie(i,t){let e=Yi(i),n=i-e,s=Yi(t),r=t-s,o=i*t;return[o,e*s-o+e*r+n*s+n*r]}var Ye=i=>[i,0],Ai=i=>[-i[0],-i[1]];function Tt(i,t){let[e,n]=Ge(i[0],t[0]);return Zi(e,n+(i[1]+t[1]))}var ie=(i,t)=>Tt(i,Ai(t));function st(i,t){let[e,n]=Ie(i[0],t[0]);return Zi(e,n+(i[0]*t[1]+i[1]*t[0]))}var Jn=(i,t)=>st(i,[t,0]),Kn=i=>st(i,i),vt=(i,t)=>[i[0]*t,i[1]*t];function Nt(i,t){let e=i[0]/t[0],[n,s]=Ie(e,t[0]),r=i[0]-n-s+(i[1]-e*t[1]);return Zi(e,r/t[0])}function Pe(i){let t=Math.sqrt(i[0]),[e,n]=Ie(t,t),s=i[0]-e-n+i[1];return Zi(t,s/(t>0?t+t:1))}var ih=(i,t)=>i.flatMap(e=>Ie(e,t)),ug=(i,t)=>t.flatMap(e=>ih(i,e));function dg(i){let t=[],e=i[0];for(let n=1;n<i.length;n++){let[s,r]=Ge(e,i[n]);e=s,t.push(r)}return t.push(e),t}function Yr(i,t=5){let e=i;for(let s=0;s<t;s++)e=dg(e);let n=e[0];for(let s=1;s<e.length-1;s++)n+=e[s];return Ge(e[e.length-1],n)}function sh(i,t=4){if(i.length<=t)return i;let e=i;for(let n=0;n<=t;n++)e=dg(e);return e.slice(-t)}var lg=new DataView(new ArrayBuffer(8));function Qe(i){if(i===0)return 0;lg.setFloat64(0,i);let t=lg.getUint32(0)>>>20&2047;return t===0?Qe(i*2**100)-100:t-1022}function fe(i,t){let e=Math.max(-1e3,Math.min(1e3,t)),n=i*2**e;return t===e?n:fe(n,t-e)}var Q1=1e-6,fg=1e27,rh=i=>{let t=String(JSON.stringify(i,(e,n)=>typeof n=="number"&&!Number.isFinite(n)?String(n):n));return t.length>80?`${t.slice(0,77)}...`:t};function Ae(i,t,e){if(typeof t=="number"&&Number.isFinite(t))return t;throw new RangeError(`\`${i}\` must be a finite number; got ${rh(t)}. Give it in ${e}.`)}function vn(i,t,e,n){let s=t!=null&&typeof t=="object"?Array.from(t):[];if(s.length===e&&s.every(r=>typeof r=="number"&&Number.isFinite(r)))return s;throw new RangeError(`\`${i}\` must be ${e} finite numbers; got ${rh(t)}. Give them in ${n}.`)}function Zr(i){let t=vn("moments",i,3,"kg m\xB2");if(t.every(e=>e>0))return t;throw new RangeError(`\`moments\` must be positive; got ${rh(t)} kg m\xB2. A body with a zero moment (a thin rod) cannot spin about that axis; check values and units.`)}function Jr(i){let t=vn("attitude",i,4,"w, x, y, z");if(Math.abs(Math.hypot(...t)-1)<Q1)return t;throw new RangeError(`\`attitude\` must be a unit quaternion w, x, y, z; got ${rh(t)}. Divide it by its norm, and check that the scalar comes first.`)}function oh(i,t,e){Ae("t",i,"seconds");let n=Ge(i,-t);if(Math.abs(n[0])*e<=fg)return n;throw new RangeError(`\`t\` less the epoch, times the rate of rotation, must be at most ${fg} rad, beyond which a phase has hardly a digit left; got ${i} s. Check times and rates.`)}function ah(i){if(!i.every(Number.isFinite))throw new RangeError("moments, momentum or their ratios leave the range of doubles: choose other units.")}function Pd([i,t,e,n],[s,r,o,a]){return[i*s-t*r-e*o-n*a,i*r+t*s+e*a-n*o,i*o-t*a+e*s+n*r,i*a+t*o-e*r+n*s]}var tw=([i,t,e,n])=>[i,-t,-e,-n],ew=([i,t,e,n])=>Math.sqrt(i*i+t*t+e*e+n*n);function Kr(i){let t=ew(i);return i.map(e=>e/t)}function va([i,t,e,n],[s,r,o]){let a=2*(e*o-n*r),c=2*(n*s-t*o),l=2*(t*r-e*s);return[s+i*a+(e*l-n*c),r+i*c+(n*a-t*l),o+i*l+(t*c-e*a)]}var As=(i,t)=>va(tw(i),t);var iw=[0,.05260015195876773,.0789002279381516,.1183503419072274,.2816496580927726,.3333333333333333,.25,.3076923076923077,.6512820512820513,.6,.8571428571428571,1],pg=[[],[[0,.05260015195876773]],[[0,.0197250569845379],[1,.0591751709536137]],[[0,.02958758547680685],[2,.08876275643042054]],[[0,.2413651341592667],[2,-.8845494793282861],[3,.924834003261792]],[[0,.037037037037037035],[3,.17082860872947386],[4,.12546768756682242]],[[0,.037109375],[3,.17025221101954405],[4,.06021653898045596],[5,-.017578125]],[[0,.03709200011850479],[3,.17038392571223998],[4,.10726203044637328],[5,-.015319437748624402],[6,.008273789163814023]],[[0,.6241109587160757],[3,-3.3608926294469414],[4,-.868219346841726],[5,27.59209969944671],[6,20.154067550477894],[7,-43.48988418106996]],[[0,.47766253643826434],[3,-2.4881146199716677],[4,-.590290826836843],[5,21.230051448181193],[6,15.279233632882423],[7,-33.28821096898486],[8,-.020331201708508627]],[[0,-.9371424300859873],[3,5.186372428844064],[4,1.0914373489967295],[5,-8.149787010746927],[6,-18.52006565999696],[7,22.739487099350505],[8,2.4936055526796523],[9,-3.0467644718982196]],[[0,2.273310147516538],[3,-10.53449546673725],[4,-2.0008720582248625],[5,-17.9589318631188],[6,27.94888452941996],[7,-2.8589982771350235],[8,-8.87285693353063],[9,12.360567175794303],[10,.6433927460157636]]],sw=[[0,.054293734116568765],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,.3111643669578199],[9,-.1521609496625161],[10,.20136540080403034],[11,.04471061572777259]],rw=[[0,.01312004499419488],[5,-1.2251564463762044],[6,-.4957589496572502],[7,1.6643771824549864],[8,-.35032884874997366],[9,.3341791187130175],[10,.08192320648511571],[11,-.022355307863886294]],ow=[[0,-.18980075407240762],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,-.4226823213237919],[9,-.1521609496625161],[10,.20136540080403034],[11,.02265179219836082]],aw=.01,ch=class{constructor(t,e){this.rates=t,this.size=e,this.stages=pg.map(()=>new Float64Array(e)),this.inner=new Float64Array(e)}step(t,e,n,s,r=!1){let{rates:o,size:a,stages:c,inner:l}=this;r||o(t,e,c[0]);for(let h=1;h<c.length;h++)mg(pg[h],c,e,n,l,a),o(t+iw[h]*n,l,c[h]);mg(sw,c,e,n,s,a)}error(t,e,n,s,r){let{size:o,stages:a}=this,[c,l]=[0,0];for(let h=0;h<o;h++){let u=r*(s[h]+Math.max(Math.abs(e[h]),Math.abs(n[h])));c+=(Ld(rw,a,h)/u)**2,l+=(Ld(ow,a,h)/u)**2}return c===0&&l===0?0:Math.abs(t)*c/Math.sqrt((c+aw*l)*o)}};function Ld(i,t,e){let n=0;for(let s=0;s<i.length;s++)n+=i[s][1]*t[i[s][0]][e];return n}function mg(i,t,e,n,s,r){for(let o=0;o<r;o++)s[o]=e[o]+n*Ld(i,t,o)}var cw=1e-12,lw=2e5,hw=2048,uw=16,[gg,Nd,dw]=[.9,.2,8],xg=-1/8,fw=16*Number.EPSILON,pw=60,ui=class{constructor({rates:t,start:e,time:n=0,scale:s,tolerance:r=cw,project:o,stops:a={},mostSteps:c=lw}){Object.assign(this,{time:n,tolerance:r,mostSteps:c}),this.scale=Float64Array.from(s),this.project=o??(()=>{}),this.stops=Object.entries(a),this._method=new ch((l,h,u)=>t(n+l,h,u),e.length),this._rates=t,this._begun=null,this._forward=this._chain(1,e),this._backward=this._chain(-1,e)}at(t){let e=t-this.time,n=e<0?this._backward:this._forward,s=this._before(n,Math.abs(e)),r=s.state.slice();return s===n.end||s.elapsed===e||this._step(s,e-s.elapsed,r),r}end(t=!0){let{end:e}=t?this._forward:this._backward;return e&&{time:this.time+e.elapsed,event:e.event}}_chain(t,e){let n=Float64Array.from(e),s={elapsed:0,state:n,step:t*this._firstStep(n),count:0};return{sense:t,kept:[s],spacing:uw,from:s,to:null,end:null}}_before(t,e){let{end:n}=t;if(n&&e>=Math.abs(n.elapsed))return n;let s=mw(t.kept,e);(e<Math.abs(t.from.elapsed)||s.count>t.from.count)&&([t.from,t.to]=[s,null]);for(let r=0;;r++){if(t.to??=this._advance(t,t.from),Math.abs(t.to.elapsed)>e)return t.from;if(t.to===t.end)return t.end;r>=this.mostSteps&&this._tooFar(t,e),[t.from,t.to]=[t.to,null],gw(t,t.from)}}_advance(t,e){let n=new Float64Array(e.state.length),s=e.step,r=dw;for(;;){(!(Math.abs(s)>fw*Math.abs(e.elapsed))||s===0)&&this._stuck(e),this._step(e,s,n);let o=this._method.error(s,e.state,n,this.scale,this.tolerance);if(o<=1){let a=o===0?r:Math.min(r,Math.max(Nd,gg*o**xg)),c={elapsed:e.elapsed+s,state:n,step:s*a,count:e.count+1};return this._ended(t,e,c)??c}s*=o>1?Math.max(Nd,gg*o**xg):Nd,r=1}}_step(t,e,n){this._method.step(t.elapsed,t.state,e,n,this._begun===t),this._begun=t,this.project(n)}_ended(t,e,n){let s=(l,h)=>this.stops.find(([,u])=>!(u(this.time+l,h)>0)),r=s(n.elapsed,n.state);if(!r)return null;let o=n.state.slice(),[a,c]=[0,n.elapsed-e.elapsed];for(let l=0;l<pw;l++){let h=.5*(a+c);this._step(e,h,o);let u=s(e.elapsed+h,o);u?[c,r]=[h,u]:a=h}return this._step(e,c,o),t.end={elapsed:e.elapsed+c,state:o,step:0,count:n.count,event:r[0]},t.end}_firstStep(t){let e=new Float64Array(t.length);this._rates(this.time,t,e);let n=o=>Math.hypot(...o.map((a,c)=>a/(this.scale[c]+Math.abs(t[c])))),[s,r]=[n(t),n(e)];return s>1e-5&&r>1e-5?.01*s/r:1e-6}_tooFar(t,e){let[n,s]=[this.time+t.sense*e,this.time+t.from.elapsed];throw new RangeError(`t = ${n} s is more than ${this.mostSteps} steps away; t = ${s} s is reached, and kept. Ask again to go on, or ask for nearer times.`)}_stuck(t){throw new RangeError(`the motion cannot be followed beyond t = ${this.time+t.elapsed} s, where it changes faster than any step. Check the parameters; losses cannot be followed far backward.`)}};function mw(i,t){let[e,n]=[0,i.length];for(;n-e>1;){let s=e+n>>1;Math.abs(i[s].elapsed)<=t?e=s:n=s}return i[e]}function gw(i,t){let e=i.kept[i.kept.length-1];t.count<=e.count||t.count%i.spacing||(i.kept.push(t),!(i.kept.length<=hw)&&(i.spacing*=2,i.kept=i.kept.filter(({count:n})=>n%i.spacing===0)))}function jr({moments:i,momentum:t,attitude:e=[1,0,0,0],epoch:n=0}){return{moments:Zr(i),momentum:vn("momentum",t,3,"kg m\xB2/s"),attitude:Kr(Jr(e)),epoch:Ae("epoch",n,"seconds")}}function Ma(i,t){let e=vn(i,t,3,"any unit: only the direction counts"),n=Math.max(...e.map(Math.abs));if(n>0){let s=e.map(o=>o/n),r=Math.hypot(...s);return s.map(o=>o/r)}throw new RangeError(`\`${i}\` must have a direction; got [0, 0, 0]. Give three numbers that are not all 0.`)}function Ze(i,t,e,n=!1){if(Ae(i,t,e)>0||n&&t===0)return t;let s=n?"not be negative":"be positive";throw new RangeError(`\`${i}\` must ${s}; got ${t}. Check its size, sign and unit, ${e}.`)}function Qr(i,t,e,n,s){let[r,o,a,c]=[i[0],i[1],i[2],i[3]];s[0]=-.5*(o*t+a*e+c*n),s[1]=.5*(r*t+a*n-c*e),s[2]=.5*(r*e+c*t-o*n),s[3]=.5*(r*n+o*e-a*t)}function to(i){let t=Math.sqrt(i[0]**2+i[1]**2+i[2]**2+i[3]**2);for(let e=0;e<4;e++)i[e]/=t}var eo=i=>Array.from(i.subarray(0,4)),no=i=>Array.from(i.subarray(4,7)),Ee=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2],lh=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]],hh=(i,t)=>({"|L|\xB2":Ee(t,t),momentum_space:va(i,t)}),io=(i,t=[])=>[1,1,1,1,i,i,i,...t];var xw=6,_w=1,yw=9,uh=class{constructor({mean_motion:t,eccentricity:e=0,mean_anomaly_at_start:n=0}){if(this.meanMotion=Ze("mean_motion",t,"rad/s"),this.eccentricity=Ze("eccentricity",e,"1",!0),!(this.eccentricity<1))throw new RangeError(`\`eccentricity\` must be below 1; got ${e}. Only ellipses come round again.`);this.meanAnomalyAtStart=Ae("mean_anomaly_at_start",n,"rad")}place(t){let e=this.meanMotion*t+this.meanAnomalyAtStart,n=this.eccentricity,s=.5*vw(e-2*Math.PI*Math.round(e/(2*Math.PI)),n),[r,o]=[Math.sin(s),Math.cos(s)],a=1-n+2*n*r*r;return[(1-n-2*r*r)/a,2*Math.sqrt((1-n)*(1+n))*r*o/a,a]}};function vw(i,t){let e=Math.abs(i),n=Math.min(e+t,e/(1-t),t>0?Math.cbrt(Math.PI**2*e/t):1/0,Math.PI);for(let s=0;s<xw;s++){let r=1-t+2*t*Math.sin(.5*n)**2;n-=((1-t)*n-e+t*Mw(n))/r}return n=Math.min(Math.max(n,0),Math.PI),i<0?-n:n}function Mw(i){if(i>=_w)return i-Math.sin(i);let t=i**3/6,e=0;for(let n=1;n<=yw;n++)e+=t,t*=-(i*i)/((2*n+2)*(2*n+3));return e}var Sw=1e-14,Sa=class{constructor({moments:t,rate:e=0,linear_drag:n=0,quadratic_drag:s=0,orbit:r=null,momentum:o,attitude:a,epoch:c}){let l=jr({moments:t,momentum:o,attitude:a,epoch:c});this.moments=l.moments,this.epoch=l.epoch,this.rate=Ze("rate",e,"s/(kg m\xB2)",!0);let h=typeof n=="number"?[n,n,n]:n;this.linearDrag=vn("linear_drag",h,3,"N m s").map(u=>Ze("linear_drag",u,"N m s",!0)),this.quadraticDrag=Ze("quadratic_drag",s,"N m s\xB2",!0),this.orbit=r===null?null:new uh(r),this.torqued=this.orbit!==null||this.quadraticDrag>0||this.linearDrag.some(u=>u>0),this._balanced=this.torqued?["kinetic_energy","|L|\xB2"]:this.rate>0?["energy"]:[],this.orbit?.eccentricity===0&&this._balanced.push("jacobi_integral"),this._motion=new ui({rates:this._rates(),start:[...l.attitude,...l.momentum,...this._balanced.map(()=>0)],time:this.epoch,scale:this._scales(l.momentum),tolerance:Sw,project:to})}_scales(t){let e=Math.max(...this.moments),n=Math.max(Math.hypot(...t),this.orbit?e*this.orbit.meanMotion:0)||e,s=this._balanced.map(r=>r==="|L|\xB2"?n*n:n*n/e);return io(n,s)}_rates(){return(t,e,n)=>{let s=this._at(t,[e[0],e[1],e[2],e[3]],[e[4],e[5],e[6]]),{momentum:r,velocity:o,drift:a,torque:c}=s,l=[o[0]+a[0],o[1]+a[1],o[2]+a[2]];Qr(e,l[0],l[1],l[2],n);let h=lh(r,l);for(let u=0;u<3;u++)n[4+u]=h[u]+c[u];this._balanced.forEach((u,d)=>n[7+d]=this._power(u,s))}}_at(t,e,n){let s=[0,1,2].map(h=>n[h]/this.moments[h]),r=lh(n,s),o=r.map(h=>this.rate*h),a=this.orbit?this._gravity(t,e):[0,0,0],c=this.quadraticDrag*Math.hypot(s[0],s[1],s[2]),l=[0,1,2].map(h=>a[h]-(this.linearDrag[h]+c)*s[h]);return{attitude:e,momentum:n,velocity:s,torqueless:r,drift:o,pull:a,torque:l}}_gravity(t,e){let[n,s,r]=this.orbit.place(t),o=As(e,[n,s,0]),a=lh(o,o.map((l,h)=>this.moments[h]*l)),c=3*this.orbit.meanMotion**2/r**3;return a.map(l=>c*l)}_relative(t,e){let n=As(t,[0,0,1]);return e.map((s,r)=>s-this.orbit.meanMotion*n[r])}_power(t,{attitude:e,momentum:n,velocity:s,torqueless:r,drift:o,pull:a,torque:c}){let l=-Ee(o,r);if(t==="|L|\xB2")return 2*Ee(c,n);if(t!=="jacobi_integral")return Ee(c,s)+l;let h=c.map((u,d)=>u-a[d]);return Ee(h,this._relative(e,s))+l-Ee(a,o)}_jacobiIntegral(t,e,n){let[s,r]=this.orbit.place(t),[o,a]=[As(e,[s,r,0]),As(e,[0,0,1])],c=this._relative(e,n),l=this.orbit.meanMotion**2,h=c.map((u,d)=>u*u+l*(3*o[d]**2-a[d]**2));return .5*Ee(this.moments,h)}state(t){let e=this._motion.at(Ae("t",t,"seconds")),[n,s]=[eo(e),no(e)],r=s.map((u,d)=>u/this.moments[d]),o=.5*Ee(s,r),a={energy:o,kinetic_energy:o,"|L|\xB2":Ee(s,s)};this.orbit&&(a.jacobi_integral=this._jacobiIntegral(t,n,r));let c=this._balanced.map((u,d)=>[u,{value:a[u],received:e[7+d]}]),l=this.torqued?{}:hh(n,s),h=this.torqued||this.rate>0?l:{energy:o,...l};return{attitude:n,momentum:s,velocity:r,energy:o,invariants:h,balances:Object.fromEntries(c),angleToMajorAxis:this._angleToMajorAxis(s)}}_angleToMajorAxis(t){if(!(Math.hypot(...t)>0))return null;let e=Math.max(...this.moments),n=t.map((s,r)=>this.moments[r]===e?s:0);return Math.atan2(Math.hypot(...t.map((s,r)=>s-n[r])),Math.hypot(...n))}};var bw=30,Dd={"air-layer":["viscosity","Pa s",!1,(i,{g:t,a:e},n)=>Math.PI*i*t*e*e/(n*n)],"boundary-layer":["coefficient","W s^(5/2)",!1,(i,t,e,n)=>i*n*n*Math.sqrt(n)],"viscous-contour-friction":["coefficient","W s\xB2",!1,(i,t,e,n)=>i*n*n],"dry-contour-friction":["coefficient","1",!1,(i,{m:t,g:e,a:n},s,r)=>i*t*e*n*r],"rolling-couple":["arm","m",!1,(i,{m:t,g:e},n,s)=>i*t*e*s*Math.sin(n)],"drilling-friction":["arm","m",!0,(i,{m:t,g:e},n,s)=>i*t*e*s*n*n]};function _g(i){if(!Array.isArray(i))throw new RangeError('`dissipation` must be a list of laws, like [{law: "air-layer", viscosity: 1.8e-5}].');return i.map((t,e)=>{let n=t!==null&&typeof t=="object"&&Object.hasOwn(Dd,t.law)&&Dd[t.law];if(!n){let l=Object.keys(Dd).join(", ");throw new RangeError(`\`dissipation[${e}].law\` must be one of ${l}; got ${JSON.stringify(t?.law)}.`)}let[s,r,o,a]=n,c=Ze(`dissipation[${e}].${s}`,t[s],r);return{vertical:o,power:(l,h,u)=>a(c,l,h,u)}})}function dh(i,t,e,n,s){let[r,o]=[0,0],[a,c]=[Math.sin(e),Math.cos(e)],l=Math.abs(a),[h,u]=[Math.min(e,Math.PI-e),Math.abs(n)/l];for(let d of t){let[f,p]=d.vertical?[a,c]:[-c/a,1],g=f*n+p*s,m=i.accelerations(f,p),x=bw*Math.sqrt(i.g/(i.a*l))/(f*m[0]+p*m[1]),_=d.power(i,h,u),M=_>=x*g*g?-g*x:-_/g;r+=f*M,o+=p*M}return[r,o]}var ww=.5772156649015329,fh=class{constructor(t){let e=Aw(t);[this.near,this.far]=[[1],[]];let n=-ww;for(let o=0;o<64;o++)this.far.push(this.near[o]*(2*n-e[o])),this.near.push(this.near[o]*(o*(o+1)+t)/(o+1)**2),n+=1/(o+1);this.near.pop();let s=.25-t,r=Math.PI*Math.sqrt(Math.abs(s));this.sine=(s<0?Math.cosh(r):Math.cos(r))/Math.PI}values(t){let e=Math.sin(.5*t)**2,n=.5*Math.sin(t);if(e<=.5){let[h,u]=Ud(this.near,e);return[h,n*u]}let s=Math.cos(.5*t)**2,r=Math.log(s),[o,a]=Ud(this.near,s),[c,l]=Ud(this.far,s);return[this.sine*(c-r*o),-n*this.sine*(l-r*a-o/s)]}};function yg(i,{m:t,a:e,C:n},s,r,o){let[a,c]=i.values(s),[l,h]=i.values(Math.PI-s),u=t*e*e*r/(n+t*e*e),d=-2*i.sine/Math.sin(s);return[(-h*o-l*u)/d,(a*u-c*o)/d]}function Aw(i){let t=.25-i,e=new Array(65),n=64,[s,r]=t>=0?[Math.sqrt(t),0]:[0,Math.sqrt(-t)];e[64]=[1,-1].reduce((o,a)=>{let[c,l]=[Math.hypot(n+a*s,r),Math.atan2(a*r,n+a*s)],h=u=>Math.cos(u*l)/c**u;return o+Math.log(c)+h(2)/24-7*h(4)/960+31*h(6)/8064-127*h(8)/30720},0);for(let o=63;o>=0;o--)e[o]=e[o+1]-(2*o+1)/(o*(o+1)+i);return e}function Ud(i,t){let[e,n]=[0,0];for(let s=i.length-1;s>=0;s--)n=e+t*n,e=i[s]+t*e;return[e,n]}var ph=class{constructor({m:t,a:e,b:n,A:s,C:r,g:o}){Object.assign(this,{m:t,a:e,b:n,A:s,C:r,g:o})}tiltAcceleration(t,e,n){let{m:s,a:r,b:o,A:a,C:c,g:l}=this,[h,u]=[Math.sin(t),Math.cos(t)];return((a+s*o*o)*e*e*u/h+s*r*o*e*(e-n*u/h)-(c+s*r*r)*e*n-s*l*(r*u-o*h))/(a+s*r*r+s*o*o)}tiltDerivatives(t,e,n){let{m:s,a:r,b:o,A:a,C:c,g:l}=this,[h,u]=[Math.sin(t),Math.cos(t)],[d,f,p]=[a+s*o*o,c+s*r*r,s*r*o],g=a+s*r*r+s*o*o,m=(p*e*n-d*e*e)/(h*h)+s*l*(r*h+o*u),x=2*d*e*u/h+2*p*e-p*n*u/h-f*n,_=-p*e*u/h-f*e;return[m/g,x/g,_/g]}transport(t,e,n){let{m:s,a:r,b:o,A:a,C:c}=this,l=Math.cos(t)/Math.sin(t);return this.accelerations(c*n-(a+s*o*o)*e*l-s*r*o*e,s*r*(r+o*l)*e)}accelerations(t,e){let{m:n,a:s,b:r,A:o,C:a}=this,[c,l,h]=[o+n*r*r,a+n*s*s,n*s*r],u=o*a+n*s*s*o+n*r*r*a;return[(l*t+h*e)/u,(h*t+c*e)/u]}energy(t,e,n,s){let{m:r,a:o,b:a,A:c,C:l,g:h}=this,u=(a*n-o*s)**2+(o*o+a*a)*e*e,d=o*Math.sin(t)-2*a*Math.sin(.5*t)**2;return .5*(c*(e*e+n*n)+l*s*s+r*u)+r*h*d}normalForce(t,e,n,s){let{m:r,a:o,b:a,g:c}=this,[l,h]=[Math.sin(t),Math.cos(t)];return r*(c+(o*h-a*l)*this.tiltAcceleration(t,n,s)-(o*l+a*h)*e*e)}};var Ew=1e-9;function vg(i,t,e,n){let{m:s,a:r,b:o,A:a,C:c,g:l}=i,[h,u]=[Math.sin(t),Math.cos(t)],d=s*l*(r*u-o*h),[f,p]=[e,n];if(f===null){if(f=Math.sqrt(d/(a*h*u-c*h*h*o/r)),!Number.isFinite(f)||!(f>0))throw new RangeError(`no steady motion has its centre at rest at tilt ${t} rad. Give \`precession\`.`);p??=f*h*o/r}let g=Ae("precession",f,"rad/s")*h;if(p??=(((a+s*o*o)*u+s*r*o*h)*h*f**2-d)/(((c+s*r*r)*h+s*r*o*u)*f),!Number.isFinite(p))throw new RangeError("`spin` must be given where nothing precesses, as in straight rolling.");let m=i.tiltAcceleration(t,g,p);if(Math.abs(m)<=Ew*(l/r+g*g+p*p))return[g,p];throw new RangeError(`tilt ${t} rad, \`precession\` ${f} and \`spin\` ${p} rad/s are not steady: the tilt would accelerate by ${m} rad/s\xB2. Give one of the rates only.`)}function Mg(i,t,e,n,s){if(!t.length)return 0;let[r,o,a]=i.tiltDerivatives(e,n,s),[c,l]=i.transport(e,n,s),h=-(r+o*c+a*l);if(!(h>0))throw new RangeError(`the steady motion at tilt ${e} rad is unstable: no slow manifold to start on. Give another tilt.`);let[u,d]=i.accelerations(...dh(i,t,e,n,s));return(o*u+a*d)/h}var Tw=1e-14,Od=1e-6,Rw=.001,Cw=9.80665,Sg=["tilt","heading","face","contact_x","contact_y","tilt_rate","rise_rate","spin"],so=class{constructor({start:t,epoch:e=0,...n}){let{disk:s,laws:r}=bg(n),{m:o,a,b:c,A:l,C:h,g:u}=s;this.moments=[l,l,h],this.onPlane=!0,[this.radius,this.halfThickness]=[a,c],this.epoch=Ae("epoch",e,"seconds"),this.thin=c===0,[this._disk,this._laws]=[s,r],this._legendre=this.thin&&!r.length?new fh(o*a*a*h/(l*(h+o*a*a))):null;let d=Math.sqrt(u/a);this._motion=new ui({rates:this._rates(),start:[...Iw(t,this.thin),0],time:this.epoch,scale:[Rw,1,1,a,a,d,d,d,o*u*a],tolerance:Tw,stops:this._stops(o*u)})}static rollingStart({tilt:t,precession:e=null,spin:n=null,heading:s=0,face:r=0,...o}){let{disk:a,laws:c}=bg(o);wg(Ae("tilt",t,"rad"),a.b===0);let l=vg(a,t,e,n);return[t,s,r,0,0,Mg(a,c,t,...l),...l]}_stops(t){let e={flat:(n,s)=>Math.sin(s[0])-Od,"lift-off":(n,s)=>this._disk.normalForce(s[0],s[5],s[6],s[7])/t};return this.thin?e:{...e,"on edge":(n,s)=>Math.cos(s[0])}}_rates(){let[t,e]=[this._disk,this._laws];return(n,s,r)=>{let[o,a,c,l,h]=[s[0],s[1],s[5],s[6],s[7]],u=l/Math.sin(o),d=h-u*Math.cos(o),[f,p]=dh(t,e,o,l,h),[g,m]=t.accelerations(f,p),[x,_]=t.transport(o,l,h);r[0]=c,r[1]=u,r[2]=h+2*u*Math.sin(.5*o)**2,r[3]=-t.a*d*Math.cos(a),r[4]=-t.a*d*Math.sin(a),r[5]=t.tiltAcceleration(o,l,h),r[6]=x*c+g,r[7]=_*c+m,r[8]=f*l+p*h}}get end(){return this._motion.end()}state(t){let e=Ae("t",t,"seconds"),[n,s,r,o,a,c,l,h,u]=this._motion.at(e),d=this._disk,[f,p]=[Math.sin(n),Math.cos(n)],[g,m,x]=[-Math.sin(s),Math.cos(s),d.b],_=r-s,M=[Math.cos(_)*c+Math.sin(_)*l,Math.cos(_)*l-Math.sin(_)*c,h],v=d.energy(n,c,l,h),b=this._motion.end(t>=this.epoch);return{attitude:Pw(n,s,r),momentum:M.map((w,y)=>this.moments[y]*w),velocity:M,energy:v,tilt:n,heading:s,face:r,invariants:this._invariants(v,n,l,h),balances:this._laws.length?{energy:{value:v,received:u}}:{},contact:[o,a],center:[o+g*(d.a*p-x*f),a+m*(d.a*p-x*f),d.a*f+x*p],normalForce:d.normalForce(n,c,l,h),parts:[n,s,r,o,a,c,l,h],ended:b&&Math.abs(t-this.epoch)>=Math.abs(b.time-this.epoch)?b.event:null}}_invariants(t,e,n,s){if(this._laws.length)return{};if(!this._legendre)return{energy:t};let[r,o]=yg(this._legendre,this._disk,e,n,s);return{energy:t,linear_integral_1:r,linear_integral_2:o}}};function bg({mass:i,radius:t,half_thickness:e=0,axial_moment:n,diametral_moment:s,gravity:r=Cw,dissipation:o=[]}){let[a,c,l]=[Ze("mass",i,"kg"),Ze("radius",t,"m"),Ze("gravity",r,"m/s\xB2")],h=Ze("half_thickness",e,"m",!0);if(h>c)throw new RangeError(`\`half_thickness\` must be at most the radius, ${c} m; got ${h}. Check units.`);let u=Ze("axial_moment",n??.5*a*c*c,"kg m\xB2"),d=Ze("diametral_moment",s??a*(.25*c*c+h*h/3),"kg m\xB2");if(u>2*d*(1+1e-12))throw new RangeError(`\`axial_moment\` must be at most twice \`diametral_moment\`; got ${u} and ${d} kg m\xB2. Check units.`);return{disk:new ph({m:a,a:c,b:h,A:d,C:u,g:l}),laws:_g(o)}}function Iw(i,t){let e=vn("start",i,Sg.length,`SI units: ${Sg.join(", ")}`);return wg(e[0],t),e}function wg(i,t){let e=t?Math.PI:.5*Math.PI;if(!(i>0&&i<e&&Math.sin(i)>Od))throw new RangeError(`the tilt at the start must lie between ${Od} rad and ${t?"\u03C0 less that":"\u03C0/2 for a thick disk"}; got ${i} rad. A disk that lies flat does not roll: start at a small tilt, such as 0.1.`)}function Pw(i,t,e){let[n,s]=[Math.sin(.5*i),Math.cos(.5*i)],[r,o]=[.5*e,t-.5*e];return[s*Math.cos(r),n*Math.cos(o),n*Math.sin(o),s*Math.sin(r)]}var Lw=1e-14,ba=class{constructor({moments:t,rotor:e,rotor_moment:n=null,rotor_drive:s="constant-rate",axis:r=null,momentum:o,attitude:a,epoch:c}){let l=jr({moments:t,momentum:o,attitude:a,epoch:c});if(this.moments=l.moments,this.epoch=l.epoch,this.rotor=vn("rotor",e,3,"kg m\xB2/s"),this.rotorMoment=n===null?null:Ze("rotor_moment",n,"kg m\xB2"),!["constant-rate","free"].includes(s))throw new RangeError(`\`rotor_drive\` must be "constant-rate" or "free"; got ${JSON.stringify(s)}.`);this.free=s==="free";let h=Math.hypot(...this.rotor)>0;this.axis=r===null?h&&Ma("rotor",this.rotor):Ma("axis",r);let u=Math.max(Math.hypot(...l.momentum),Math.hypot(...this.rotor))||Math.max(...this.moments);this._motion=new ui({rates:this._rates(),start:[...l.attitude,...l.momentum],time:this.epoch,scale:io(u),tolerance:Lw,project:to})}_rates(){let[t,e,n]=this.moments,[s,r,o]=this.rotor;return(a,c,l)=>{let[h,u,d]=[c[4],c[5],c[6]],[f,p,g]=[(h-s)/t,(u-r)/e,(d-o)/n];Qr(c,f,p,g,l),l[4]=u*g-d*p,l[5]=d*f-h*g,l[6]=h*p-u*f}}state(t){let e=this._motion.at(Ae("t",t,"seconds")),[n,s]=[eo(e),no(e)],r=s.map((l,h)=>l-this.rotor[h]),o=r.map((l,h)=>l/this.moments[h]),a=.5*Ee(r,o),c={energy:a,...hh(n,s)};return{attitude:n,momentum:s,velocity:o,energy:a,invariants:c,rotorRate:this.rotorRate(o)}}rotorRate(t){return this.rotorMoment===null||!this.axis?null:Ee(this.rotor,this.axis)/this.rotorMoment-(this.free?Ee(t,this.axis):0)}};var ro=1e-12,Nw=1e-12;function Ag(i,t,e,n){if(t===0)return["Euler's |\u03A0|\xB2",s=>Ee(s,s)];if(Dw(i,e))return["Lagrange's \u03A0\xB7\u03C7",s=>Ee(s,e)];for(let s=0;s<3;s++){let[r,o]=Eg(s);if(!Tg(i[r],i[o])||Math.abs(e[s])>ro)continue;let a={moments:i,axis:e,i:r,j:o,k:s,strength:t/i[s]};if(Math.abs(i[r]/2-i[s])<=ro*i[s])return["Kovalevskaya's integral",Ow(a)];if(Math.abs(i[r]/4-i[s])<=ro*i[s])return["Goryachev and Chaplygin's integral",Uw(...n)?Fw(a):()=>NaN]}return null}var Eg=i=>[(i+1)%3,(i+2)%3],Tg=(i,t)=>Math.abs(i-t)<=ro*i;function Dw(i,t){let e=Math.max(...i);return e-Math.min(...i)<=ro*e?!0:[0,1,2].some(n=>{let[s,r]=Eg(n);return Tg(i[s],i[r])&&Math.abs(t[s])+Math.abs(t[r])<=ro})}var Uw=(i,t)=>Math.abs(Ee(i,t))<=Nw*Math.hypot(...i)*Math.hypot(...t);function Ow({moments:i,axis:t,i:e,j:n,strength:s}){return(r,o)=>{let[a,c]=[r[e]/i[e],r[n]/i[n]],l=a*a-c*c-s*(o[e]*t[e]-o[n]*t[n]),h=2*a*c-s*(o[e]*t[n]+o[n]*t[e]);return l*l+h*h}}function Fw({moments:i,axis:t,i:e,j:n,k:s,strength:r}){return(o,a)=>{let c=o.map((l,h)=>l/i[h]);return c[s]*(c[e]**2+c[n]**2)-r*Ee(c,t)*a[s]}}var Bw=1e-14,wa=class{constructor({moments:t,mgl:e,axis:n=[0,0,1],momentum:s,attitude:r,epoch:o}){let a=jr({moments:t,momentum:s,attitude:r,epoch:o});this.moments=a.moments,this.epoch=a.epoch,this.mgl=Ae("mgl",e,"N m"),this.axis=Ma("axis",n);let c=As(a.attitude,[0,0,1]);this._third=Ag(this.moments,this.mgl,this.axis,[a.momentum,c]);let l=Math.max(...this.moments),h=Math.max(Math.hypot(...a.momentum),Math.sqrt(Math.abs(this.mgl)*l))||l;this._motion=new ui({rates:this._rates(),start:[...a.attitude,...a.momentum],time:this.epoch,scale:io(h),tolerance:Bw,project:to})}_rates(){let[t,e,n]=this.moments,[s,r,o]=this.axis.map(a=>this.mgl*a);return(a,c,l)=>{let[h,u,d,f]=[c[0],c[1],c[2],c[3]],[p,g,m]=[c[4],c[5],c[6]],[x,_,M]=[p/t,g/e,m/n];Qr(c,x,_,M,l);let[v,b,w]=[2*(u*f-h*d),2*(d*f+h*u),h*h-u*u-d*d+f*f];l[4]=g*M-m*_+b*o-w*r,l[5]=m*x-p*M+w*s-v*o,l[6]=p*_-g*x+v*r-b*s}}state(t){let e=this._motion.at(Ae("t",t,"seconds")),[n,s]=[eo(e),no(e)],r=s.map((l,h)=>l/this.moments[h]),o=As(n,[0,0,1]),a=.5*Ee(s,r)+this.mgl*Ee(o,this.axis),c={energy:a,"|P|\xB2":Ee(o,o),"\u03A0\xB7P":Ee(s,o)};return this._third&&(c[this._third[0]]=this._third[1](s,o)),{attitude:n,momentum:s,velocity:r,energy:a,invariants:c}}};var Aa=2*Math.PI,zw=[.08,.25,.5,.75],kw=2400,Fd=160,Gw=.05,jn=i=>[0,1,2].sort((t,e)=>i[t]-i[e]||t-e);function Vw(i){let[t,e,n]=jn(i);return i[t]<i[e]&&i[e]<i[n]}function ir(i,t,e=kw){let n=jn(i),[s,r,o]=n.map(_=>i[_]),[a,c,l]=n.map(_=>t[_]/Math.hypot(...t));if(s===o)return null;let h=s*(o-r)*l*l-o*(r-s)*a*a;if(h===0&&s<r&&r<o)return null;let u=h>0,d=u?s*(o-r)/(r*(o-s)):o*(r-s)/(r*(o-s)),f=u?a:l,p=Math.sqrt(c*c+(d>0?f*f/d:0)),g=Math.sqrt(f*f+d*c*c);if(g===0||!(p<=1+1e-12))return null;let m=Math.sign(u?l:a)||1,x=[];for(let _ of Hw(Math.min(p,1),e)){let[M,v]=[g*Math.cos(_),p*Math.sin(_)],b=m*Math.sqrt(Math.max(0,1-M*M-v*v)),w=[0,0,0];[w[n[0]],w[n[1]],w[n[2]]]=u?[M,v,b]:[b,v,M],x.push(...w)}return x}function Hw(i,t){let e=[];for(let s=0;s<t;s++)e.push(Aa*s/t);let n=Math.sqrt(Math.max(0,1-i*i));for(let s=.02*n;n>0&&s<.5;s+=Gw*Math.max(s,.4*n)){let r=Math.asin(s);for(let o of[.25*Aa,.75*Aa])e.push(o-r,o+r)}return e.push(Aa),e.sort((s,r)=>s-r)}function Cg(i){let t=jn(i),[e,n,s]=t.map(o=>i[o]);if(e===s)return[];let r=[e<n,e===s,n<s];return t.flatMap((o,a)=>[1,-1].map(c=>{let l=[0,0,0];return l[o]=c,{at:l,verdict:r[a]?"stable":"unstable"}}))}function Ig(i){let t=jn(i),[e,n,s]=t.map(a=>i[a]),r=[];if(e===s)return r;let o=Math.atan2(Math.sqrt((s-n)*e),Math.sqrt((n-e)*s));for(let[a,c,l]of[[t[2],t[0],o],[t[0],t[2],.5*Math.PI-o]])if(!(l<1e-9))for(let h of zw){let u=[0,0,0];[u[a],u[c]]=[Math.cos(h*l),Math.sin(h*l)],r.push(...Ea(i,u))}return r}function Ea(i,t){let e=ir(i,t,Fd);return e?[...Bd(e),...Bd(e.map(n=>-n))]:[]}function Pg(i){if(!Vw(i))return[];let t=jn(i),[e,n,s]=t.map(a=>i[a]),r=Math.atan2(Math.sqrt((s-n)*e),Math.sqrt((n-e)*s)),o=[];for(let a of[1,-1]){let c=[];for(let l=0;l<=Fd;l++){let h=[0,0,0],u=Aa*l/Fd;h[t[1]]=Math.cos(u),h[t[0]]=a*Math.sin(u)*Math.sin(r),h[t[2]]=Math.sin(u)*Math.cos(r),c.push(...h)}o.push(...Bd(c))}return o}var Ei=64,Rg=9;function Lg(i,t,e){if(!(e>0))return[];let n=c=>c.reduce((l,h,u)=>l+(e*h-t[u])**2/i[u],0),s=[],[r,o]=[1/0,-1/0];for(let c=0;c<6;c++){let l=[];for(let h=0;h<=Ei;h++)for(let u=0;u<=Ei;u++){let d=[0,0,0];d[c%3]=c<3?1:-1,d[(c+1)%3]=Math.tan((2*h/Ei-1)*.25*Math.PI),d[(c+2)%3]=Math.tan((2*u/Ei-1)*.25*Math.PI);let f=Math.hypot(...d),p=d.map(m=>m/f),g=n(p);[r,o]=[Math.min(r,g),Math.max(o,g)],l.push([p,g])}s.push(l)}let a=[];if(!(o-r>1e-12*Math.abs(o)))return a;for(let c of s)for(let l=0;l<Ei;l++)for(let h=0;h<Ei;h++){let[u,d,f,p]=[c[l*(Ei+1)+h],c[(l+1)*(Ei+1)+h],c[(l+1)*(Ei+1)+h+1],c[l*(Ei+1)+h+1]];for(let g of[[u,d,f],[u,f,p]])Ww(g,r,o,a)}return a}function Ww(i,t,e,n){let s=i.map(([,c])=>c),r=(e-t)/(Rg+1),o=Math.max(1,Math.ceil((Math.min(...s)-t)/r)),a=Math.min(Rg,Math.floor((Math.max(...s)-t)/r));for(let c=o;c<=a;c++){let l=t+c*r,h=[];for(let u=0;u<3;u++){let[[d,f],[p,g]]=[i[u],i[(u+1)%3]];if(f<l==g<l)continue;let m=(l-f)/(g-f),x=d.map((M,v)=>M+m*(p[v]-M)),_=Math.hypot(...x);h.push(x.map(M=>M/_))}h.length===2&&n.push(...h[0],...h[1])}}function Bd(i){let t=[];for(let e=0;e+5<i.length;e+=3)t.push(...i.slice(e,e+6));return t}var zd={"-":"\u207B",0:"\u2070",1:"\xB9",2:"\xB2",3:"\xB3",4:"\u2074",5:"\u2075",6:"\u2076",7:"\u2077",8:"\u2078",9:"\u2079"};function zt(i,t=6){if(i===0)return"0";let e=Math.abs(i);if(e>=.001&&e<1e6)return(e>=10**t?String(Number(i.toPrecision(t))):i.toPrecision(t)).replace("-","\u2212");let[n,s]=i.toExponential(t-1).split("e"),r=[...s.replace("+","")].map(o=>zd[o]).join("");return`${n}\xB710${r}`.replace("-","\u2212")}var qw=[[31557600,"yr"],[86400,"d"],[3600,"h"],[60,"min"]],Xw=[[1,"s"],[.001,"ms"],[1e-6,"\xB5s"],[1e-9,"ns"],[1e-12,"ps"],[1e-15,"fs"]];function kd(i){return qw.find(([t])=>i>=3*t)??Xw.find(([t])=>i>=.3*t)??null}function Mn(i,t){let[e,n]=kd(t)??[null];return e?`${(i/e).toFixed($w(t/e))} ${n}`:`${zt(i,4)} s`}var $w=i=>Math.max(0,Math.min(4,4-Math.ceil(Math.log10(Math.max(i,1e-9))))),Wt=i=>String(i);var Gd=Math.PI/30,Ng=Math.PI/180;function tn(i,t){let[e,n,s]=[0,1,2].map(r=>i[(t+r)%3]);return{rate:Math.hypot(...i),tilt:Math.atan2(Math.hypot(n,s),e),around:n||s?Math.atan2(s,n):0}}function Og(i,{rate:t,tilt:e,around:n}){let s=[0,0,0];return s[i]=t*Math.cos(e),s[(i+1)%3]=t*Math.sin(e)*Math.cos(n),s[(i+2)%3]=t*Math.sin(e)*Math.sin(n),s}var Es={rate:1,about:1,tilt:1,angular_velocity:3,momentum:3,attitude:4},On=(i,t)=>`[${i.map(e=>`"${Wt(e)} ${t}"`).join(", ")}]`,Ts=i=>i.map(Math.abs).reduce((t,e,n,s)=>e>s[t]?n:t,0),Rs=i=>i.map((t,e)=>({key:`body.moments.${e}`,label:`moment of inertia I${"\u2081\u2082\u2083"[e]}`,unit:"kg m\xB2",value:t,...Yw(i,e)}));function Yw(i,t){let[e,n]=[i[(t+1)%3],i[(t+2)%3]],[s,r]=[Math.abs(e-n),e+n];return{low:Math.max(s,.001*r),high:r,log:!0}}function Cs({velocity:i,about:t,around:e}){let{rate:n,tilt:s}=tn(i,t),r=n<.001*Gd||n>1e6*Gd;return[{key:"spin.rate",label:"spin rate |\u03A9|",unit:r?"rad/s":"rpm",si:r?1:Gd,value:n,log:!0,low:n/20||.1,high:20*n||100},{key:"spin.about",label:"tilt counted from",value:t,choices:[0,1,2].map(o=>[o,`axis ${o+1}`])},{key:"spin.tilt",label:"tilt of the spin",unit:"\xB0",si:Ng,value:s,low:0,high:Math.PI,power:2},{key:"spin.around",label:`tilted towards (0\xB0 is axis ${(t+1)%3+1})`,unit:"\xB0",si:Ng,value:s>0?tn(i,t).around:e,low:-Math.PI,high:Math.PI}]}function Is(i,t,e){let[,n,s]=t.split(".");if(n==="moments"){let o=i.moments.map((a,c)=>c===Number(s)?e:a);return{...i,moments:o,momentum:null}}if(n==="about")return{...i,about:e,around:tn(i.velocity,e).around};let r={...tn(i.velocity,i.about)};return r.tilt>0||(r.around=i.around),r[n]=e,{...i,velocity:Og(i.about,r),around:r.around,momentum:null}}function Ps(i,{body:t={},spin:e={}},n=[0,0,0]){let s={...i};if(t.moments&&(s={...s,moments:Jw(t.moments),momentum:null}),e.attitude&&(s.attitude=e.attitude.map(Number)),e.momentum){let d=e.momentum.map(Number),f=d.map((p,g)=>(p-n[g])/s.moments[g]);return{...s,momentum:d,velocity:f,around:tn(f,s.about).around}}if(e.angular_velocity){let d=e.angular_velocity.map(Number);return{...s,momentum:null,velocity:d,around:tn(d,s.about).around}}if(["rate","about","tilt"].every(d=>e[d]===void 0))return s;if(e.about!==void 0&&![1,2,3].includes(e.about))throw new RangeError(`spin.about must be 1, 2 or 3, a principal axis; got ${e.about}.`);let r=Zw(s.moments),o=e.about===void 0?r.findIndex(d=>d[s.about]!==0):e.about-1,a=tn(r.map(d=>Fg(d,s.velocity)),o),c={rate:e.rate??a.rate,tilt:e.tilt??a.tilt,around:e.tilt===void 0?a.around:0},l=Og(o,c),h=[0,1,2].map(d=>r.reduce((f,p,g)=>f+p[d]*l[g],0)),u=r[o].findIndex(d=>d!==0);return{...s,about:u,around:tn(h,u).around,momentum:null,velocity:h}}var Fg=(i,t)=>i.reduce((e,n,s)=>e+n*t[s],0);function Zw(i){let t=jn(i),e=(t[1]-t[0])*(t[2]-t[0])*(t[2]-t[1])<0;return t.map((n,s)=>[0,1,2].map(r=>r===n?e&&s===2?-1:1:0))}function Jw(i){let t=i[0]+i[1]+i[2];if(i.every(e=>e>0&&2*e<=t*(1+1e-9)))return i;throw new RangeError(`Moments must be positive and satisfy I1 + I2 \u2265 I3; got ${i.join(", ")} kg m\xB2. No rigid body has these.`)}var Qn=({moments:i,velocity:t,momentum:e},n=[0,0,0])=>e??t.map((s,r)=>s*i[r]+n[r]),[Kw,Dg]=[60,24];function mh(i,t,e=[0,0,1]){let n=i.state(i.epoch),s=2*Math.PI/(Math.hypot(...n.velocity)||1)/Dg,[r,o]=Qw(e),[a,c]=[[],[]],[l,h]=[0,null],u=Kw*Dg;for(let M=0;M<=u;M++){let v=t(i.state(i.epoch+M*s)),[b,w,y]=[r,o,e].map(I=>Fg(I,v));a.push(Math.atan2(Math.hypot(b,w),y));let S=Math.atan2(w,b);h!==null&&(l+=Math.atan2(Math.sin(S-h),Math.cos(S-h))),h=S,c.push(l)}let[d,f]=[Math.min(...a),Math.max(...a)],p=jw(a),[g,m,x]=p.length>1?[p[0],p.at(-1),p.length-1]:[0,u,null],_=(Ug(c,m)-Ug(c,g))/((m-g)*s);return{least:d,most:f,swing:x?(m-g)*s/x:null,around:_}}var Ug=(i,t)=>{let e=Math.min(Math.floor(t),i.length-2);return i[e]+(t-e)*(i[e+1]-i[e])};function jw(i){let t=[];for(let e=1;e+1<i.length;e++){let[n,s,r]=[i[e-1],i[e],i[e+1]];s>n&&s>=r&&n-2*s+r<0&&t.push(e+.5*(n-r)/(n-2*s+r))}return t}function Qw([i,t,e]){let n=Math.abs(e)<.9?[0,0,1]:[1,0,0],s=[n[1]*e-n[2]*t,n[2]*i-n[0]*e,n[0]*t-n[1]*i],r=Math.hypot(...s),[o,a,c]=s.map(l=>l/r);return[[o,a,c],[t*c-e*a,e*o-i*c,i*a-t*o]]}function Ta([i,t,e,n],[s,r,o]){let[a,c,l]=[2*(e*o-n*r),2*(n*s-t*o),2*(t*r-e*s)];return[s+i*a+e*l-n*c,r+i*c+n*a-t*l,o+i*l+t*c-e*a]}var tA=2e3,eA=5*Math.PI/180,nA=["rate","spin.tilt","spin.rate"],iA={body:{moments:3},system:{kind:0,damping:1,sink_rate:1,linear_drag:1,quadratic_drag:1},spin:Es};function sA({moments:i,rate:t=0,linear_drag:e=0,quadratic_drag:n=0,momentum:s,attitude:r=[1,0,0,0],epoch:o=0}){let a=s.map((l,h)=>l/i[h]),c=Ts(a);return{moments:i,velocity:a,attitude:r,epoch:o,about:c,around:tn(a,c).around,momentum:s,rate:t,linear_drag:e,quadratic_drag:n}}function rA(i){let t=1/(Math.hypot(...Qn(i))||1);return[{key:"rate",label:"losses inside, \u03B1",unit:"s/(kg m\xB2)",value:i.rate,low:0,high:5*Math.max(i.rate,.02*t),power:2},...Rs(i.moments),...Cs(i)]}var oA=(i,t,e)=>t==="rate"?{...i,rate:e}:Is(i,t,e),aA=i=>new Sa({...i,momentum:Qn(i)}),cA=({moments:i,rate:t,linear_drag:e,quadratic_drag:n,velocity:s,attitude:r})=>({body:{moments:i},system:{kind:"damped-body",sink_rate:t,linear_drag:e,quadratic_drag:n},spin:{angular_velocity:s,attitude:r}});function lA(i,t){let{system:e={}}=t,n={...i};for(let[o,a]of[["sink_rate","rate"],["linear_drag","linear_drag"],["quadratic_drag","quadratic_drag"]])e[o]!==void 0&&(n[a]=e[o]);let s=Ps(n,t);if(e.damping===void 0)return s;let r=Math.hypot(...Qn(s));return{...s,rate:r>0?e.damping/r:0}}function hA(i,t){let{moments:e,rate:n,linear_drag:s,quadratic_drag:r,velocity:o,attitude:a}=i,c=Math.hypot(...Qn(i)),l=n>0&&c>0?`damping = ${Wt(n*c)}
`:"",h=s>0?`linear_drag = "${Wt(s)} N*m*s"
`:"",u=r>0?`quadratic_drag = "${Wt(r)} N*m*s^2"
`:"";return!l&&!h&&!u?null:`[body]
moments = ${On(e,"kg*m^2")}

[system]
kind = "damped-body"
${l}${h}${u}
[spin]
angular_velocity = ${On(o,"rad/s")}
attitude = [${a.map(Wt).join(", ")}]

[time]
until = "${Wt(t)} s"
`}function uA({moments:i,velocity:t,rate:e},n){let{energy:s,momentum:r}=n.state(n.epoch),o=Math.hypot(...r);if(!(o>0))return[["what it does","at rest"]];let[a,,c]=jn(i).map(d=>i[d]),l=[["what it does",e>0&&a<c?"loses energy and ends spinning about its axis of largest moment":"keeps |L|"]],h=o*o/(2*c);l.push(["energy it can lose inside",`${zt(100*(s-h)/s,3)} %`]);let u=e>0?Bg(n,Math.hypot(...t)):null;return u!==null&&l.push(["within 5\xB0 of the flat spin after",Mn(u,u)]),l}var dA=({velocity:i,rate:t},e)=>t>0?Bg(e,Math.hypot(...i)):null;function Bg(i,t){let e=2*Math.PI/t/4,n=null;for(let s=0;s<4*tA;s++){let{angleToMajorAxis:r}=i.state(i.epoch+s*e);if(!(r<eA))n=null;else{if((n??=s*e)<.5*s*e)return n;if(n===0)return 0}}return n}var Wd={};as(Wd,{asSpec:()=>vA,changed:()=>_A,controls:()=>xA,facts:()=>bA,from:()=>mA,keys:()=>pA,make:()=>yA,toml:()=>SA,withSpec:()=>MA});var Hd=Math.PI/180,fA=.02,Ra={"air-layer":["viscosity","Pa*s","viscosity of the air"],"boundary-layer":["coefficient","W*s^2.5","loss in the boundary layer"],"viscous-contour-friction":["coefficient","W*s^2","viscous friction of the contact"],"dry-contour-friction":["coefficient","","dry friction of the contact"],"rolling-couple":["arm","m","lever arm of rolling friction"],"drilling-friction":["arm","m","lever arm of drilling friction"]},pA={system:{kind:0,mass:1,radius:1,thickness:1,gravity:1,tilt:1},dissipation:Object.fromEntries(Object.keys(Ra).map(i=>[i,1]))};function mA({mass:i,radius:t,half_thickness:e,diametral_moment:n,axial_moment:s,gravity:r,dissipation:o,start:a,epoch:c=0}){let h=Math.abs(s-.5*i*t**2)<1e-12*s&&Math.abs(n-i*(.25*t**2+e**2/3))<1e-12*n?null:[n/(i*t**2),s/(i*t**2)],u={mass:i,radius:t,half_thickness:e,shares:h,gravity:r,dissipation:o,tilt:a[0],heading:a[1],face:a[2],start:a,epoch:c};return{...u,moments:xh(u),steady:gA(u)}}var xh=({shares:i,mass:t,radius:e,half_thickness:n})=>{let[s,r]=i?i.map(o=>o*t*e**2):[t*(.25*e**2+n**2/3),.5*t*e**2];return[s,s,r]},zg=i=>{let[t,,e]=xh(i),{mass:n,radius:s,half_thickness:r,gravity:o,dissipation:a}=i,c=Object.entries(a).map(([l,h])=>({law:l,[Ra[l][0]]:h}));return{mass:n,radius:s,half_thickness:r,gravity:o,diametral_moment:t,axial_moment:e,dissipation:c}},kg=i=>so.rollingStart({...zg(i),tilt:i.tilt,heading:i.heading,face:i.face});function gA(i){try{let t=kg(i),e=Math.hypot(...t.slice(6));return[6,7].every(n=>Math.abs(t[n]-i.start[n])<fA*e)}catch{return!1}}function xA(i){let{tilt:t,radius:e,half_thickness:n,mass:s,gravity:r,dissipation:o}=i;return[{key:"tilt",label:"tilt of the face at first",unit:"\xB0",si:Hd,value:t,low:Math.min(t,Hd),high:80*Hd,log:!0},{key:"radius",label:"radius",unit:"mm",si:.001,value:e,low:e/5,high:5*e,log:!0},{key:"thickness",label:"thickness",unit:"mm",si:.001,value:2*n,low:0,high:e},{key:"mass",label:"mass",unit:"g",si:.001,value:s,low:s/20,high:20*s,log:!0},{key:"gravity",label:"gravity",unit:"m/s\xB2",value:r,low:r/10,high:3*r,log:!0},...Object.entries(o).map(([a,c])=>({key:`law.${a}`,label:Ra[a][2],unit:Ra[a][1].replace("*"," ").replace("^2.5","^(5/2)").replace("^2","\xB2"),value:c,low:c/100,high:100*c,log:!0}))]}function _A(i,t,e){let[n,s]=t.split(".");return gh(s?{...i,dissipation:{...i.dissipation,[s]:e}}:n==="thickness"?{...i,half_thickness:.5*e}:{...i,[n]:e})}function gh(i){let t={...i,steady:!0,epoch:0};return{...t,start:kg(t),moments:xh(t)}}var yA=i=>new so({...zg(i),start:i.start,epoch:i.epoch}),vA=({mass:i,radius:t,half_thickness:e,gravity:n,tilt:s,dissipation:r})=>({system:{kind:"euler-disk",mass:i,radius:t,thickness:2*e,gravity:n,tilt:s},dissipation:r});function MA(i,{system:t={},dissipation:e={}}){let n={...i,dissipation:{...i.dissipation,...e}};for(let[s,r]of Object.entries(n.dissipation))r===0&&delete n.dissipation[s];for(let s of["mass","radius","gravity","tilt"])t[s]!==void 0&&(n[s]=t[s]);return t.thickness!==void 0&&(n.half_thickness=.5*t.thickness),gh(n)}function SA(i,t){if(!i.steady)return null;let{mass:e,radius:n,half_thickness:s,shares:r,gravity:o,tilt:a,heading:c,dissipation:l}=i,[h,,u]=xh(i),d=r?`axial_moment = "${Wt(u)} kg*m^2"
diametral_moment = "${Wt(h)} kg*m^2"
`:"",f=Object.entries(l).map(([p,g])=>{let[m,x]=Ra[p];return`{ law = "${p}", ${m} = ${x?`"${Wt(g)} ${x}"`:Wt(g)} }`});return`[system]
kind = "euler-disk"
mass = "${Wt(e)} kg"
radius = "${Wt(n)} m"
thickness = "${Wt(2*s)} m"
${d}gravity = "${Wt(o)} m/s^2"
tilt = "${Wt(a)} rad"
heading = "${Wt(c)} rad"
dissipation = [${f.join(", ")}]

[time]
until = "${Wt(t)} s"
`}function bA(i,t){let e=t.state(t.epoch),n=e.parts[6]/Math.sin(e.tilt),s=2*Math.PI/Math.abs(n),r=t.state(t.epoch+20*s),o=r.balances.energy?r.balances.energy.received-e.balances.energy.received:0,a=[["contact goes round every",`${zt(s,4)} s`],["energy at first",`${zt(e.energy,5)} J`],["energy less losses, change in 20 rounds",zt(Math.abs(r.energy-o-e.energy)/e.energy,2)]];return o&&a.push(["lost in 20 rounds",`${zt(-100*o/e.energy,3)} %`]),r.ended&&a.push(["ends",r.ended==="flat"?"flat on the table, within 20 rounds":`by ${r.ended}, within 20 rounds`]),a}var Zd={};as(Zd,{asSpec:()=>CE,changed:()=>EE,controls:()=>wE,dragged:()=>vE,event:()=>NE,facts:()=>LE,first:()=>ME,from:()=>bE,keys:()=>SE,make:()=>RE,toml:()=>PE,withDirection:()=>TE,withSpec:()=>IE});var Gg=2e-8,wA=20;function Vg(i,t,e){let n=vt(Tt(i,t),.5),s=.5*(i[0]-t[0]+(i[1]-t[1])),r=ie(e,Kn(n)),o=r[0]+r[1]+s*s;return{x:s/n[0],e:o/(2*n[0]*n[0]+o),middle:n}}function Ca(i,t,e){let n=Math.min(Qe(i[0]),0),s=2**n,r=2**-n;[i,t,e]=[vt(i,r),vt(t,r),vt(vt(e,r),r)];let o=Ne,a=Ne;for(let d=0;d<3+wA;d++){let f=Vg(i,t,e);if(d>=3&&Math.abs(f.x)<Gg&&Math.abs(f.e)<Gg)break;let p=st(i,t),g=Tt(e,p),m=Nt(ie(e,p),g);o=vt(st(o,m),.5),e=vt(Nt(Kn(g),e),.25),[i,t]=[vt(Tt(i,t),.5),Pe(p)],a=Tt(a,o)}let{x:c,e:l,middle:h}=Vg(i,t,e),u=.5*o[0]*l;return a=Tt(a,[u+u*(.25*(l*l-.5*c*c)),0]),{mean:vt(Tt(h,[-.25*h[0]*c*c,0]),s),total:a}}function Ia(i,t){let e=1+Math.sqrt(t),n=.5/((1+t)*e*e),s=n*i,r=s*s*(s*s);return n*(1+r*(2+r*(15+r*(150+r*1707))))}var Pa=i=>2*(i+i**4+i**9),AA=20;function Hg(i,t){let[e,n,s]=[i,t,Ne];for(let d=0;d<AA;d++){let[f,p,g]=[Pe(e),Pe(n),Pe(s)],m=Tt(Tt(st(f,p),st(p,g)),st(g,f));[e,n,s]=[e,n,s].map(x=>vt(Tt(x,m),.25))}let r=Nt(Tt(Tt(e,n),s),[3,0]),[o,a]=[e,n].map(d=>ie(Ne,Nt(d,r))[0]),c=-o-a,l=o*a-c*c,h=o*a*c,u=-l/10+h/14+l*l/24-3*l*h/44;return Nt(Tt(Ne,Ye(u)),Pe(r))}function Wg(i){let{A:t,B:e,C:n,P:s,Q:r,G2:o,moments:a,canonical:c,longAxis:l,rootS:h}=i,u=st(e,r),[d,,f]=c,p=!(u[0]>0)||!(i.rootP>0)||d===0&&f===0,g=!(n[0]>0&&h[0]>0)&&!p,m=Pe(o),x=Pe(u),_={modulus:x,mean:Ne,precession:yn,G:m,constant:p,separatrix:g};if(p)return _;let[M,v,b]=a,w=l?-1:1;if(g)return{..._,precession:st(m,Ie(w*M,b))};let y=e[0]>=t[0],S=y?st(r,n):st(st(e,n),o),{mean:I,total:T}=Ca(x,st(Pe(n),h),S),L=Ie(w*(l===y?M:b),v),N=st(y?t:s,T),F=y?vt(N,-.5):vt(Nt(N,o),.5),P=st(m,Tt(L,F));return{..._,mean:I,precession:y?P:Tt(P,I)}}var EA=2**-900,TA=100,RA=1e-280;function qg(i,t){let e=[0,1,2].sort((j,W)=>i[j]-i[W]||j-W),[n,s,r]=e,o=(s-n)*(r-n)*(r-s)>0?1:-1,a=t.map(Math.abs),c=Math.max(...a),l=Math.min(...a.map(j=>j===0?c:j)),h=Qe(i[r]),u=Qe(c)-(l<EA*c?TA:0),d=e.map(j=>fe(i[j],-h)),f=e.map(j=>o*fe(t[j],-u)),[p,g,m,x,_,M]=CA(d,f),v=Qe(Math.max(Math.abs(f[0]),Math.abs(f[2]))),b=[fe(f[0],-v),f[1],fe(f[2],-v)],w=IA(d,b,p,g),y=w[0]>0,S=y?w:Ai(w),[I,T]=y?[f[2],f[0]]:[f[0],f[2]],L=T<0?-1:1,N=[L,1,L],F=y?[r,s,n]:e,P=fe(1,v),[B,G,H]=y?[g,p,_]:[p,g,x];return{moments:d,momentum:f,canonical:[I*L,f[1],T*L],A:B,B:G,C:m,P:H,Q:y?x:_,S:vt(vt(S,-P),P),rootS:vt(Pe(S),P),rootP:PA(H[0],m[0],I,G[0],f[1]),V:Jn(Ie(d[0],d[1]),d[2]),G2:M,longAxis:y,axes:[0,1,2].map(j=>[0,1,2].map(W=>F[W]===j?o*N[W]:0)),momentumScale:fe(1,u),rateScale:fe(1,u-h)}}function CA(i,t){let e=Jn(Ge(i[1],-i[0]),i[2]),n=Jn(Ge(i[2],-i[1]),i[0]),s=Jn(Ge(i[2],-i[0]),i[1]),[r,o,a]=t.map(h=>Ie(h,h)),c=Tt(st(s,r),st(n,o)),l=Tt(st(e,o),st(s,a));return[e,n,s,c,l,Tt(Tt(r,o),a)]}function IA(i,t,e,n){let s=st(e,Ie(t[0],t[0])),r=ie(s,st(n,Ie(t[2],t[2])));if(!(Math.abs(r[0])<.01*s[0]))return r;let o=Ge(i[1],-i[0]),a=Ge(i[2],-i[1]);for(let c of[i[2],t[0],t[0]])o=ih(o,c);for(let c of[-i[0],t[2],t[2]])a=ih(a,c);return Yr([...o,...a])}function PA(i,t,e,n,s){if(i>RA)return Math.sqrt(i);let r=Qe(Math.max(Math.abs(e),Math.abs(s))),[o,a]=[e,s].map(c=>fe(c,-r));return fe(Math.sqrt(t*o*o+n*a*a),r)}function Ti([i,t]){let e=Yi(i);return[e,i-e,t]}function Ls(i,t,e,n){let s=i[0]*t,r=i[0]*e,o=i[1]*t,a=Math.round(s),c=Math.round(r),l=Math.round(o),h=i[1]*e+i[2]*(t+e),u=r-c,d=o-l,f=u+d,p=f-u,g=u-(f-p)+(d-p),m=s-a,x=m+f,_=x-m,M=m-(x-_)+(f-_),v=Math.round(x);n[0]=x-v,n[1]=M+(g+h),n[2]=a+(c+l)+v}function Ns(i,t){let e=Math.tan(i*Math.PI),n=2/(e*e+1);t[0]=e*n,t[1]=n-1}function oo(i,t,e,n){let s=Yi(i),r=i-s,o=s*n+r*(e+n)+t*e;return Math.exp(-(s*e))*(1-o*(1-.5*o))}var di=i=>i-Math.round(i);var Xg=[2**-400,2**-200],LA=[138.62943611198907,-33555121496085278e-31],[ao,Ds,Ji,Tn]=[3,3,2,4].map(i=>new Float64Array(i));function $g(i,t,e){let{constant:n,separatrix:s}=t,r=i.A[0]*i.P[0],o=-i.C[0]*i.S[0],a=n||r<=o&&!s,c=vt(Nt(ya,i.V),i.rateScale),l=vt(st(t.precession,c),.5),h=vt(st(t.mean,c),2),u=vt(h,.25),d=vt(Nt(t.modulus,i.V),i.rateScale),f=a?ie(l,u):l,p=a?Tt(l,u):s?d:h;n&&([f,p]=[NA(i),yn]);let m={...n?DA():a?UA(i,r,o):OA(i,t,r,o),full:a,first:Ti(f),second:Ti(p)};return{...m,...FA(m,i,t,e)}}function NA(i){let[t,e,n]=i.momentum.map((r,o)=>Kn(Nt(Ye(r),Ye(i.moments[o])))),s=st(Pe(Tt(Tt(t,e),n)),ya);return vt(s,.5*i.rateScale)}var DA=()=>({start:0,a:[1,0,0,0,0],b:[0,0,0,0,0]});function Yg(i,t,e,n,s){let[r,o,a,c]=[1,i,1,e];for(let l=0;l<5;l++){let h=(r-o)/(r+o);[r,o]=[.5*(r+o),Math.sqrt(r*o)];let u=1+h,d=Math.sqrt(1-h*(1-t)/(1+t));a*=d/u,c=2*c/(u*(n+s)),s=Math.sqrt(1+h*(s-n)/(s+n)),[n,t]=[1,d]}return[a,c]}function UA(i,t,e){let[n,s,r,o]=[i.A[0],i.B[0],i.C[0],i.Q[0]],[a,c,l]=i.canonical,h=s*o,u=Ia(t/h,Math.sqrt(e/h)),d=u*(t/h),f=i.rootP/Math.sqrt(o),[p,g]=Yg(Math.sqrt(e/h),l*Math.sqrt(r/o),Math.sqrt(s),Math.sqrt(s),Math.sqrt(r)),m=g+Math.sqrt(f*f+g*g),x=f/m,_=n/s*u*m*m,M=Math.atan2(Math.sqrt(s)*c*p,Math.sqrt(r)*a)*(.25/Math.PI),v=x*x,b=d*d,w=b*b,y=w*w,[S,I]=[-d*v,-b*_],[T,L]=[w*b*v*v,y*_*_],N=T+L,F=[1-N,S+I,2*N,S-I,2*(T-L)];[S,T,L]=[-b*d*v,y*b*v*v,w*_*_],N=T+L;let P=[x*(1-N),x*(S-_),2*x*N,x*(S+_),2*x*(T-L)];return{start:M,a:F,b:P}}function OA(i,t,e,n){let[s,r,o,a,c]=[i.B[0],i.C[0],i.P[0],i.Q[0],t.G[0]],[l,h,u]=i.canonical,{separatrix:d}=t,f=d?1:Math.sqrt(e/(s*a)),p=d?0:n/(s*a),g=p*Ia(p,f),m=Math.sqrt(r)*Math.abs(l),x=Math.sqrt(r)*u*Math.sqrt(o/a),_=Math.abs(Math.sqrt(s)*h),M=m+x<Xg[0]*_,[v,b]=Yg(f,Math.sqrt(o/s)/c,M?Xg[1]*_:_,m,x),w=Math.atan(Math.sqrt(a/o)*v),y=M?Math.log(2*b):Math.asinh(b),S=M?.5*Math.exp(y):Math.sinh(y),I=Zi(y,(b-S)/(M?S:Math.sqrt(1+S*S)));M&&(I=Tt(I,LA)),I=vt(I,h<0!=l<0?-1:1);let T=Ne;if(!d){let B=Pa(g);T=Nt(st(t.modulus,En),t.mean),T=Tt(T,[-T[0]*(B*(2+B)/((1+B)*(1+B))),0])}let L=[0,1,2,3,4].map(B=>(2*B+1)*(.5*w-.25*Math.PI)),[N,F,P]=Ti(T);return{start:Nt(I,T),cosines:L.map(Math.cos),sines:L.map(Math.sin),rootNome:Math.sqrt(g),decay:[N,F+P],yTurns:d?0:w*(.5/Math.PI),periodic:d?0:1,parity:l<0?1:0}}function FA(i,t,e,{moments:n,momentum:s,attitude:r}){let{constant:o}=e;Zg(i,0,0);let a=Math.sqrt(Tn.reduce((_,M)=>_+M*M,0)),[c,l,h,u]=Tn.map(_=>_/a),d=[[c,l,h,u],[-u,h,-l,c],[h,u,-c,-l],[-l,c,u,-h]],f=t.longAxis?-1:1,p=BA(n,s),g=[0,1,2,3].map(_=>{if(o)return Pd(r,[_===0?1:0,...p.map(v=>_===1?v:0)]);let M=t.axes.map(v=>f*v.reduce((b,w,y)=>b+w*d[1+y][_],0));return Pd(r,[d[0][_],...M])}),m=e.G[0]*t.momentumScale,x=o?s.flatMap(_=>[0,0,_]):t.axes.flat().map(_=>m*_);return{toAttitude:[0,1,2,3].flatMap(_=>g.map(M=>M[_])),toMomentum:x}}function BA(i,t){let e=Math.max(...t.map(Math.abs));if(!(e>0))return[0,0,0];let n=Math.min(...i),s=t.map((o,a)=>o/e*(n/i[a])),r=Math.sqrt(s.reduce((o,a)=>o+a*a,0));return s.map(o=>r>0?o/r:0)}function Zg(i,t,e){i.full?zA(i,t,e):kA(i,t,e)}function zA(i,t,e){let{a:n,b:s,start:r}=i;Ls(i.first,t,e,ao),Ls(i.second,t,e,Ds),Ns(di(ao[0]+(ao[1]-r)),Ji);let o=Ji[0],a=Ji[1];Ns(di(Ds[0]+(Ds[1]+r)),Ji);let c=Ji[0],l=Ji[1],h=a*l+o*c,u=c*a-l*o,d=u+u,f=1-d*u,p=d*h,g=n[0]+f*(n[1]+f*n[2]),m=p*(n[3]+f*n[4]),x=s[0]+f*(s[1]+f*s[2]),_=p*(s[3]+f*s[4]);Tn[0]=a*g-o*m,Tn[1]=a*m+o*g,Tn[2]=l*x-c*_,Tn[3]=l*_+c*x}function kA(i,t,e){let{start:n,periodic:s,decay:r,cosines:o,sines:a,rootNome:c}=i;Ls(i.first,t,e,ao),Ls(i.second,t,e,Ds);let l=(1-s)*Ds[2],[h,u]=Ge(l,Ds[0]),[d,f]=Ge(h,n[0]),[p,g]=Zi(d,Ds[1]+(n[1]+(u+f))),m=s*Math.round(p),x=p-m,_=i.parity+(s*Ds[2]+m);_-=4*Math.round(.25*_);let M=di(ao[0]-.25*_)+(ao[1]-x*i.yTurns),v=x<0?-1:1,b=x*v,w=g*v,y=oo(b,w,r[0],r[1]),S=Math.max(.5-b,0),I=s*oo(S,(.5-S-b)*s-w,r[0],r[1]);Ns(di(M),Ji);let T=c*c,L=T*T,N=1,F=y,P=c*I,B=T*y,[G,H,j,W,Y]=[0,0,0,0,-1];for(let X=0;X<5;X++){let rt=N+F,xt=N-F;G+=o[X]*rt,H+=a[X]*xt,j+=Y*a[X]*rt,W-=Y*o[X]*xt,N*=P,F*=B,P*=T,B*=T,Y=-Y}H*=v,W*=v;let tt=1-2*(_-2*Math.floor(.5*_)),gt=Ji[0],wt=Ji[1];Tn[0]=wt*G-gt*H,Tn[1]=wt*H+gt*G,Tn[2]=tt*(wt*j-gt*W),Tn[3]=tt*(wt*W+gt*j)}function Jg(i,t,e){Zg(i,t,e);let[n,s,r,o]=[Tn[0],Tn[1],Tn[2],Tn[3]],a=n*n+s*s,c=r*r+o*o,l=1/(a+c),h=Math.sqrt(l),u=(n*r+s*o)*(l+l),d=(n*o-s*r)*(l+l),f=(a-c)*l,[p,g]=[i.toAttitude,i.toMomentum],[m,x,_,M]=[n*h,s*h,r*h,o*h],v=w=>p[w]*m+p[w+1]*x+p[w+2]*_+p[w+3]*M,b=w=>g[w]*u+g[w+1]*d+g[w+2]*f;return{attitude:[v(0),v(4),v(8),v(12)],momentum:[b(0),b(3),b(6)]}}var GA=1e-14,fi=class{constructor({moments:t,momentum:e,attitude:n=[1,0,0,0],epoch:s=0}){this.moments=Zr(t),this.momentumAtEpoch=vn("momentum",e,3,"kg m\xB2/s"),this.attitudeAtEpoch=Kr(Jr(n)),this.epoch=Ae("epoch",s,"seconds");let r={moments:this.moments,momentum:this.momentumAtEpoch,attitude:this.attitudeAtEpoch},o=qg(r.moments,r.momentum),a=Wg(o);this._fastest=Math.max(...r.momentum.map((d,f)=>Math.abs(d/r.moments[f]))),this._motion=$g(o,a,r);let{first:c,second:l,toAttitude:h,toMomentum:u}=this._motion;ah([this._fastest,...c,...l,...h,...u]),this._curve={body:o,rates:a},this.energy=.5*r.momentum.reduce((d,f,p)=>d+f/r.moments[p]*f,0),this.momentumNorm=Math.hypot(...r.momentum),Object.assign(this,VA(r,o,a))}state(t){let[e,n]=oh(t,this.epoch,this._fastest),s=Yi(e);return Jg(this._motion,s,e-s+n)}angularVelocity(t){let e=this.state(t).momentum;return[e[0]/this.moments[0],e[1]/this.moments[1],e[2]/this.moments[2]]}along(t){let{body:e,rates:n}=this._curve,s=this.momentumAtEpoch;if(n.constant)return Array.from({length:t},()=>[...s]);let[r,o,a,c,l]=[e.A,e.B,e.C,e.P,e.Q].map(_=>_[0]),h=o*l,[u,d]=n.separatrix?[1,0]:[r*c/h,-a*e.S[0]/h],[f,p]=e.canonical,g=e.rootP,m=Math.atan2(Math.sqrt(o)*p,Math.sqrt(a)*f),x=n.separatrix&&f<0?-1:1;return Array.from({length:t},(_,M)=>{let v=n.separatrix?Math.PI*(M/Math.max(t-1,1)-.5):m+2*Math.PI*M/t,b=x*Math.cos(v),w=x*Math.sin(v),y=[g/Math.sqrt(a)*b,g/Math.sqrt(o)*w,Math.sqrt(l/a)*Math.sqrt(d+u*b*b)];return e.axes.map(S=>e.momentumScale*(S[0]*y[0]+S[1]*y[1]+S[2]*y[2]))})}};function VA(i,t,e){let n=HA(i,t,e);if(e.constant)return{regime:n,encircledAxis:null,modulus:null,period:null,precessionRate:null,precessionPerPeriod:null,flipInterval:null,solidAngle:null};let s=t.longAxis?-1:1,r=s*vt(Nt(e.precession,t.V),t.rateScale)[0];if(e.separatrix)return{regime:n,encircledAxis:null,modulus:1,period:1/0,precessionRate:r,precessionPerPeriod:1/0,flipInterval:1/0,solidAngle:null};let o=Nt(vt(En,2),e.mean),a=st(e.precession,o),c=st(o,t.V)[0]/t.rateScale;return{regime:n,encircledAxis:t.axes.findIndex(l=>l[2]!==0),modulus:Math.sqrt(t.A[0]/t.B[0])*(t.rootP/Math.sqrt(t.Q[0])),period:c,precessionRate:r,precessionPerPeriod:s*a[0],flipInterval:n==="symmetric"?null:.5*c,solidAngle:WA(t,e,a,o)}}function HA({moments:i,momentum:t},e,n){let[s,r,o]=e.moments;return t.every(a=>a===0)?"rest":s===o?"spherical":n.constant?"permanent":n.separatrix?"separatrix":s===r||r===o?"symmetric":e.longAxis?"long-axis":"short-axis"}function WA(i,t,e,n){if(i.A[0]===0){let u=i.C[0]*i.G2[0];return 2*Math.PI*i.P[0]/u/(1+Math.sqrt(i.Q[0]/u))}let[s,r,o]=i.moments;if(i.P[0]/(i.B[0]*i.G2[0])<GA)return Math.PI*i.P[0]/(Math.sqrt(i.B[0]*i.C[0])*i.G2[0]);let c=Ie(i.longAxis?-o:s,r),l=Tt(i.P,st(c,i.G2)),h=st(Nt(l,t.G),n);return ie(vt(En,2),ie(e,h))[0]}function jg(i,t){let e=i.momentum[2],n=i.s0[0]===0||i.t0[0]===0,s=i.w2[0]===0&&(n||i.G[0]===0&&e===0),r=!(t.B[0]>0)&&!s,o=i.cPlus[0]>=0?1:-1,a=i.c[0]>=0?1:-1,c=vt(i.cPlus,o),[l,h]=i.moments,u=Nt(Jn(Ge(l,-h),e),Ye(h)),d=Pe(t.A),f={halfRoot:vt(d,.5),signAlpha:o,signBeta:a,spin:u,permanent:s,separatrix:r,steady:!1};if(s)return{...f,nutation:yn,alpha:yn,beta:yn};if(r)return{...f,nutation:yn,alpha:vt(c,.25*o),beta:yn};let p=XA(i,t,d,c,vt(i.c,a)),g={nutation:p.nutation,alpha:vt(p.alpha,o),beta:vt(p.beta,a)};return{...f,...i.leaves?qA(i,f.halfRoot,g):g,steady:!(t.d[0]>0)}}var qd=i=>i.leaves?Jn(hg,i.lift):yn;function qA(i,t,{nutation:e,alpha:n,beta:s}){let r=vt(i.cPlus,.25),o=vt(Nt(st(qd(i),e),st(En,t)),2),a=Nt(Ne,Tt(Ne,o));return{nutation:st(e,a),alpha:Tt(r,st(ie(n,r),a)),beta:st(s,a)}}function XA(i,t,e,n,s){let{G:r}=i,{A:o,B:a,s1:c,s2:l,t1:h,t2:u,d,zMinus:f,zPlus:p}=t,g=Pe(a),m=p[0]<=2*o[0],x=st(r,l)[0]<=f[0],_=m?p:Nt(st(o,u),h),v=x&&s[0]===0?o:x?f:Nt(st(c,a),l),b=Ca(e,g,_),w=Ca(e,g,v),y=vt(b.mean,.5),S=Kg(r,n,p,h,u,d,y,b.total,m),I=Kg(r,s,f,l,c,d,y,w.total,x);return{nutation:y,alpha:S,beta:x?Ai(I):I}}function Kg(i,t,e,n,s,r,o,a,c){let l=t[0]===0;if(c)return vt(st(Nt(st(t,i),l?Ne:e),a),.25);let h=vt(Nt(t,l?Ne:n),.5),u=vt(st(Nt(r,s),a),.5);return ie(st(h,ie(Ne,u)),o)}var[$A,YA]=[-200,-150];function Qg(i,t,e,n){let s=t<0,r=s?[-n[1],n[0],n[3],-n[2]]:[...n],[o,a,c,l]=r,h=s?-1:1,u=Qe(i[0]),d=JA(i[0],Math.abs(t),e),[f,p]=[i[0],i[2]].map(G=>fe(G,-u)),g=[e[0],h*e[1],h*e[2]],m=g.map(G=>fe(G,-d)),x=fe(Math.abs(t),u-d),_=fe(x,-d),M=vt(Ie(_,f),2),v=sh([..._h(a,c),..._h(o,l)]),{below:b,lift:w,kept:y}=ZA(M,m,r),I=[...[0,1].map(G=>y*fe(g[G],w-d)),m[2]],[T,L]=b?[0,w]:[w,0],[N,F]=[a,c].map(G=>y*fe(G,T)),P=[fe(o,L),N,F,fe(l,L)],B=KA(M,v,I,P);return{moments:[f,p],momentum:I,quaternion:P,...B,reversed:s?-1:1,lift:w,upright:!b,leaves:w>0&&!b&&B.D[0]>0,momentumScale:fe(1,d),rateScale:fe(1,d-u)}}var _h=(i,t)=>sh([...Ie(i,i),...Ie(t,t)]);function ZA(i,[t,e,n],[s,r,o,a]){let c=(_,M)=>Math.max(Math.abs(_),Math.abs(M)),[l,h]=[c(s,a),c(r,o)],u=l<h,d=Math.max(Math.min(l,h),c(t,e)),f=Qe(d),[p,g]=[vt(i,2),Ie(n,n)],m=!u&&p[0]===g[0]&&p[1]===g[1],x=d>0&&f<$A&&i[0]>0;return{below:u,lift:x&&!m?YA-f:0,kept:x&&m?0:1}}function JA(i,t,e){let n=Math.max(...e.map(Math.abs)),s=Qe(n);if(!(t>0))return s;let r=Math.floor((Qe(i)+Qe(t)+1)/2);return n>0?Math.max(s,r):r}function KA(i,t,[e,n,s],[r,o,a,c]){let l=Ie,h=ug,u=sh,d=F=>F.map(P=>-P),f=_h(o,a),p=_h(r,c),g=u([...l(o,r),...l(a,c)]),m=u([...l(o,c),...l(-a,r)]),x=u([...h(g,[e]),...h(m,[-n])]),_=u([...h(g,[n]),...h(m,[e])].map(F=>2*F)),M=u([..._,...h(f,[-2*s])]),v=u([..._,...h(p,[2*s])]),b=[...l(e,e),...l(n,n)],w=u([...h(t,b),...h(i.map(F=>-2*F),f)],5),y=u([...w,...h(M,[-s])],5),S=[...i.map(F=>2*F),...l(s,-s)],I=u([...h(t,S),...d(w)],5),T=u([...h(w,[s]),...h(d(i),M)],6),L=Yr(t),N=F=>Nt(Yr(F),L);return{size:L,G:i,s0:vt(N(f),2),t0:vt(N(p),2),u0:N([...p,...d(f)]),p:vt(N(x),-2),c:N(M),cPlus:N(v),twist:N(_),F:N(y),D:N(I),w2:Yr(b),lean:N(T)}}var jA=-400,QA=5;function n0(i){let{G:t}=i,e=Kn(i.p),n=Kn(i.c),s=Ye(i.momentum[2]),r=ie(vt(st(s,i.twist),2),st(t,st(i.s0,i.t0)));r=ie(r,vt(st(i.u0,i.w2),2));let a=[ie(ie(vt(st(t,i.u0),2),i.w2),Kn(s)),st(t,r),st(Kn(t),e)],{root:c,cosine:l}=t0(a),h;if(l>=0||!(t[0]>0))h=tE(i,e,n,r,e0(c,a));else{let f=[Ai(Nt(i.D,t)),vt(Nt(i.F,t),-2),Nt(n,t)];h=eE(i,e,n,e0(t0(f).root,f))}let u=Tt(i.t0,h.fromUpper),d=Tt(h.Y,st(t,i.t0));return{...h,t2:u,zPlus:d,t1:pi(Kn(i.cPlus),st(u,d))}}function t0([[i],[t],[e]]){let n=t-i*i/3,s=2*i**3/27-i*t/3+e,r=Math.sqrt(Math.max(-n/3,0)),o=r>0?Math.min(Math.max(-.5*s/r**3,-1),1):1;return{root:2*r*Math.cos(Math.acos(o)/3)-i/3,cosine:o}}function e0(i,[t,e,n]){let s=Ye(i);for(let r=0;r<QA;r++){let o=Tt(st(Tt(st(Tt(s,t),s),e),s),n),a=Tt(st(Tt(Tt(vt(s,2),s),vt(t,2)),s),e),c=Nt(o,a);Number.isFinite(c[0])&&(s=ie(s,c))}return s}var pi=(i,t)=>i[0]===0?i:Nt(i,t);function i0(i,t){let e=Qe(i[0]),n=t[0]===0||Qe(t[0])<2*e,s=i[0]!==0&&e<jA&&n?-e:0,r=fe(1,s),o=vt(vt(t,r),r),a=Pe(Tt(Kn(vt(i,r)),vt(o,4)));return vt(a,fe(1,-s))}function s0(i,t,e){let n=i[0]>=0,s=vt(Tt(t,n?i:Ai(i)),.5),r=s[0]>0?pi(e,s):yn;return n?[s,r]:[r,s]}function tE(i,t,e,n,s){let{G:r}=i,o=pi(t,s),a=pi(Tt(n,st(r,o)),s),c=i0(a,o),[l,h]=s0(a,c,o),u=Tt(i.s0,h),d=ie(i.s0,l),f=ie(s,st(r,i.s0));f[0]>=st(r,d)[0]?d=pi(e,st(u,f)):f=pi(e,st(u,d));let p=Tt(s,st(r,h)),g=ie(s,st(r,l));return{fromLower:h,fromUpper:l,d:c,s1:u,s2:d,A:p,B:g,Y:s,zMinus:f}}function eE(i,t,e,n){let{G:s}=i,r=st(s,n),o=pi(e,r),a=Nt(Tt(vt(i.F,-2),pi(e,n)),r),c=i0(a,o),[l,h]=s0(a,c,o),u=st(s,h),d=Tt(st(s,i.s0),u),f=pi(t,d),p=ie(i.s0,l),g=ie(n,i.s0);p[0]>=g[0]?g=pi(f,p):p=pi(f,g);let m=st(s,Tt(n,h));return{fromLower:g,fromUpper:p,d:ie(n,l),s1:n,s2:l,A:m,B:st(s,c),Y:d,zMinus:u}}var[Us,Fn,De]=[3,2,10].map(i=>new Float64Array(i));function r0(i){return o0(i,0,0),[...De]}function o0(i,t,e){i.full?nE(i,t,e):iE(i,t,e)}function La(i,t,e){return Ls(i,t,e,Us),Us[0]+Us[1]}function nE(i,t,e){let{aSum:n,aGap:s,bSum:r,bGap:o}=i.series;Ns(di(La(i.third,t,e)+i.start[0]),Fn);let a=Fn[0],c=Fn[1],l=1-2*a*a,h=2*a*c,[u,d,f,p,g,m,x,_]=[0,0,0,0,0,0,0,0];for(let w=0;w<4;w++){let y=2*w+1;u+=n[w]*a,d+=s[w]*c,f+=r[w]*c,p+=o[w]*a,g+=y*n[w]*c,m+=y*s[w]*a,x+=y*r[w]*a,_+=y*o[w]*c;let S=c*l-a*h;a=a*l+c*h,c=S}let[M,v]=i.signs,b=La(i.first,t,e);a0(u,-M*d,f,v*p,g,M*m,-x,v*_,b,La(i.second,t,e))}function a0(i,t,e,n,s,r,o,a,c,l){De[0]=i,De[1]=t,De[2]=e,De[3]=n,De[4]=s,De[5]=r,De[6]=o,De[7]=a,De[8]=c,De[9]=l}function iE(i,t,e){let{start:n,periodic:s,decay:r,q:o,poleTurns:a,signs:c}=i,{aSine:l,aCosine:h,bCosine:u,bSine:d,constant:f}=i.series;Ls(i.third,t,e,Us);let[p,g]=Ge((1-s)*Us[2],Us[0]),[m,x]=Ge(p,n[0]),[_,M]=Zi(m,Us[1]+(n[1]+(g+x))),v=s*Math.round(_),b=_-v,w=s*Us[2]+v,y=.5*(w-2*Math.floor(.5*w)),S=b<0?-1:1,I=b*S,T=M*S,L=oo(I,T,r[0],r[1]),N=Math.max(.5-I,0),F=s*oo(N,(.5-N-I)*s-T,r[0],r[1]),P=L*L,B=F*F,[G,H,j,W,Y,tt,gt,wt]=[0,0,f,0,0,0,0,0],X=1,rt=P,xt=B,At=o*P,pt=o*B,[Dt,me]=[o*o*B,o*o*o*P];for(let se=0;se<4;se++){let[ge,Cn]=[2*se+1,2*se+2],Le=X*(1+rt),un=X*(1-rt);G+=l[se]*Le,H+=h[se]*un,Y+=ge*l[se]*un,tt+=ge*h[se]*Le,j+=u[se]*(xt+At),W+=d[se]*(xt-At),gt+=Cn*u[se]*(xt-At),wt+=Cn*d[se]*(xt+At),X*=pt,pt*=o*o,rt*=P*P,xt*=Dt,Dt*=o*o,At*=me,me*=o*o}let Rt=2*L,[Zt,te]=c,Vt=b+M,Te=di(La(i.first,t,e)+Zt*Vt*a[0])+y,Me=di(La(i.second,t,e)+te*Vt*a[1])+y;a0(G,Zt*S*H,Rt*j,-te*S*Rt*W,S*Y,Zt*tt,S*Rt*gt,-te*Rt*wt,Te,Me)}function c0(i,t,e){o0(i,t,e);let[n,s,r,o]=[De[0],De[1],De[2],De[3]],[a,c,l,h]=[De[4],De[5],De[6],De[7]],{phases:u,gain:d}=i,f=1/(n*n+s*s+(r*r+o*o)),p=Math.sqrt(f);Ns(di(De[8]),Fn);let g=Fn[1]*u[0]-Fn[0]*u[1],m=Fn[0]*u[0]+Fn[1]*u[1];Ns(di(De[9]),Fn);let x=Fn[1]*u[2]-Fn[0]*u[3],_=Fn[0]*u[2]+Fn[1]*u[3],M=(n*g-s*m)*p,v=(n*m+s*g)*p,b=(r*x-o*_)*p,w=(r*_+o*x)*p,y=n*l+s*h-(r*a+o*c),S=n*h-s*l-(o*a-r*c),I=(d[0]*y+d[1]*(s*r-n*o))*f,T=(d[0]*S+d[1]*(n*r+s*o))*f,L=x*g+_*m,N=_*g-x*m,F=[I*L-T*N,i.reversed*(I*N+T*L),i.axial];return{attitude:i.reversed<0?[b,-M,-v,w]:[M,b,w,v],momentum:F}}var Xd=[0,1,2,3];function l0(i,t,e,n){let s=sE(i,t,e),{permanent:r,separatrix:o,nutation:a}=e,{full:c,q:l,theta3:h}=s,[u,d]=aE(i,e).map(b=>cE(i,b)),f=fe(1,i.leaves?0:-i.lift),p=i.upright?[1,f]:[f,1],m=r?hE(i):(c?uE:dE)(t,s,p),x=r?0:c?a[0]:e.halfRoot[0]/(h*h),_=lE(e,s),M=2*(_[0]+_[1]),v={full:c,first:Ti(u),second:Ti(d),...oE(i,e,s),series:m,q:l,poleTurns:[s.yAlpha,s.yBeta].map(b=>o||c?0:b/Math.PI),periodic:o?0:1,signs:r?[1,1]:[e.signAlpha,e.signBeta],gain:[2*x*i.momentumScale,M*i.momentumScale],axial:n,reversed:i.reversed};return{...v,phases:fE(i,r0(v),_,x)}}function sE(i,t,e){let{separatrix:n,permanent:s,steady:r}=e,[o,a,c,l]=[i.G[0],t.d[0],t.A[0],t.B[0]],h=o*a/c,u=n?0:l/c,d=s||h<=u&&!n,f=s?0:d?h:u,p=f*Ia(f,Math.sqrt(1-f)),g=1+Pa(p),m=1/(g*g),x={full:d,q:p,theta3:g,yAlpha:0,yBeta:0,rAlpha:0,rBeta:0,x0:yn};if(s)return x;if(r)return{...x,yAlpha:1/0,yBeta:1/0};let _=rE(i,t),M=n?Math.atan2(Math.sqrt(t.t1[0]),Math.sqrt(a)):_.alpha(),v=n||t.s2[0]===0?0:_.beta(),b=w=>d&&p>0?Math.exp(-2*m*w()):0;return{...x,yAlpha:M*m,yBeta:v*m,rAlpha:b(_.beyondAlpha),rBeta:b(_.beyondBeta),x0:vt(Tt(_.start(),qd(i)),i.p[0]>=0?1:-1)}}function rE(i,t){let{G:e}=i,{A:n,B:s,d:r,s1:o,s2:a,t1:c,t2:l,Y:h,zMinus:u,zPlus:d,fromLower:f,fromUpper:p}=t,g=Nt,m=(x,_,M)=>{let v=_[0]+M[0];return st(Pe(x),v>0&&Number.isFinite(v)?Hg(_,M):Ne)};return{alpha:()=>m(g(c,l),g(r,l),g(st(r,d),st(n,l)))[0],beta:()=>{let x=st(o,s);return m(g(st(a,n),x),g(st(r,u),x),g(r,o))[0]},beyondAlpha:()=>m(g(n,d),g(st(e,c),d),g(st(e,l),d))[0],beyondBeta:()=>m(g(u,s),g(st(e,a),s),g(st(e,o),n))[0],start:()=>m(g(f,r),g(p,r),g(h,n))}}function oE(i,t,e){let{permanent:n,separatrix:s,halfRoot:r,nutation:o}=t;if(n)return{third:[0,0,0],start:[.25,0],decay:[1,0]};let a=i.moments[0];if(s){let m=Nt(vt(r,i.rateScale),Ye(a));return{third:Ti(m),start:e.x0,decay:[1,0]}}let c=e.full?.5:1,l=Nt(vt(o,i.rateScale),Jn(En,a)),h=Nt(st(r,En),o),u=Pa(e.q),d=u*(2+u)/(e.theta3*e.theta3),[f,p,g]=Ti(Tt(h,[-h[0]*d,0]));return{third:Ti(vt(l,c)),start:vt(Nt(e.x0,h),c),decay:[f,p+g]}}function aE(i,t){let e=vt(t.spin,.5);if(!t.permanent)return[Tt(t.alpha,e),ie(t.beta,e)];let[n,s]=i.moments,r=Nt(Ie(.5*i.momentum[2],n),Ye(s));return[r,Ai(r)]}function cE(i,t){let e=Nt(ya,Ye(i.moments[0]));return vt(st(t,e),i.rateScale)}function lE(i,t){if(i.permanent)return[0,0];let e=t.full||i.separatrix,n=(s,r)=>e?0:s*r*i.nutation[0]*(2/Math.PI);return[i.alpha[0]+n(i.signAlpha,t.yAlpha),i.beta[0]+n(i.signBeta,t.yBeta)]}function hE(i){let t=[0,0,0,0],[e,n]=[i.t0[0],i.s0[0]].map(s=>Math.sqrt(.5*s));return{aSum:[e,0,0,0],aGap:t,bSum:t,bGap:[n,0,0,0]}}function uE(i,{q:t,theta3:e,yAlpha:n,yBeta:s,rAlpha:r,rBeta:o},[a,c]){let l=1-2*(t-t**4+t**9),h=(g,m,x,_)=>{let M=Math.exp(-2*m),v=Xd.map(y=>y?(t**y*x)**y:1),b=v.reduceRight((y,S,I)=>y+S*(1+M**(2*I+1)),0),w=v.map((y,S)=>g/b*(_&&S%2?-1:1)*y);return[1,-1].map(y=>w.map((S,I)=>S*(1+y*M**(2*I+1))))},[u,d]=h(a*Math.sqrt(.5*i.t2[0])*e,n,r,!0),[f,p]=h(c*Math.sqrt(.5*i.s1[0])*l,s,o,!1);return{aSum:u,aGap:d,bSum:f,bGap:p}}function dE(i,{q:t,theta3:e,yAlpha:n,yBeta:s}){let r=h=>1-2*(t*Math.cos(2*h)-t**4*Math.cos(4*h)+t**9*Math.cos(6*h)),o=Math.sqrt(.5*i.t2[0])*e/r(n),a=Math.sqrt(.5*i.s1[0])*(1+t**2+t**6+t**12)/r(s),c=h=>Xd.map(u=>o*(u%2?-1:1)*h((2*u+1)*n)),l=h=>Xd.map(u=>a*(u%2?1:-1)*h((2*u+2)*s));return{aSine:c(Math.sin),aCosine:c(Math.cos),bCosine:l(Math.cos),bSine:l(Math.sin),constant:a}}function fE(i,t,e,n){let[s,r,o]=i.momentum,a=Pe(i.size),[c,l,h,u]=i.quaternion.map(G=>Nt(Ye(G),a)[0]),d=[[c,u],[l,h]],f=[[.5*(-o*u-(s*l+r*h)),.5*(o*c-(s*h-r*l))],[.5*(s*c-r*u+o*h),.5*(s*u+r*c-o*l)]],p=fe(1,i.lift),[g,m]=i.upright?[1,p]:[p,1],[x,_,M,v]=[0,1,4,5].map(G=>g*t[G]),[b,w,y,S]=[2,3,6,7].map(G=>m*t[G]),[I,T]=t.slice(8),L=x*x+_*_+(b*b+w*w),N=Math.sqrt(L),F=(x*M+_*v+(b*y+w*S))/L,P=s*s+r*r+o*o+i.G[0]||1;return[[x,_,M,v,I],[b,w,y,S,T]].flatMap(([G,H,j,W,Y],tt)=>{let[gt,wt,X]=[G/N,H/N,e[tt]],rt=n*(j/N-gt*F)-X*wt,xt=n*(W/N-wt*F)+X*gt,[[At,pt],[Dt,me]]=[d[tt],f[tt]],Rt=gt*At+wt*pt+(rt*Dt+xt*me)/P,Zt=gt*pt-wt*At+(rt*me-xt*Dt)/P,[te,Vt]=[Math.cos(2*Math.PI*Y),Math.sin(2*Math.PI*Y)],[Te,Me]=[Rt*te+Zt*Vt,Zt*te-Rt*Vt],se=Math.sqrt(Te*Te+Me*Me);return se>0?[Te/se,Me/se]:[1,0]})}var Na=class{constructor({moments:t,mgl:e,momentum:n,attitude:s=[1,0,0,0],epoch:r=0}){if(this.moments=Zr(t),this.moments[0]!==this.moments[1])throw new RangeError(`\`moments\` must be (I1, I1, I3), the first two equal; got ${JSON.stringify(this.moments)} kg m\xB2. Give one of them twice if they differ by rounding, and put the axis of symmetry third.`);this.mgl=Ae("mgl",e,"N m"),this.momentumAtEpoch=vn("momentum",n,3,"kg m\xB2/s"),this.attitudeAtEpoch=Jr(s),this.epoch=Ae("epoch",r,"seconds");let o=this.momentumAtEpoch,a=Qg(this.moments,this.mgl,o,this.attitudeAtEpoch),c=n0(a),l=jg(a,c),h=Math.max(...o.map((S,I)=>Math.abs(S/this.moments[I])));this._fastest=h+Math.sqrt(Math.abs(this.mgl)/this.moments[0]),this._motion=l0(a,c,l,o[2]);let{first:u,second:d,third:f,start:p,gain:g,phases:m}=this._motion;ah([this._fastest,...u,...d,...f,...p,...g,...m]);let[x,_,M,v]=this.attitudeAtEpoch,[b,w]=[x*x+v*v,_*_+M*M],y=.5*o.reduce((S,I,T)=>S+I/this.moments[T]*I,0);this.energy=y+this.mgl*(b-w)/(b+w),this.verticalMomentum=va(Kr(this.attitudeAtEpoch),o)[2],this.axialMomentum=o[2],Object.assign(this,pE(a,c,l))}state(t){let[e,n]=oh(t,this.epoch,this._fastest),s=Yi(e);return c0(this._motion,s,e-s+n)}angularVelocity(t){let e=this.state(t).momentum;return[e[0]/this.moments[0],e[1]/this.moments[1],e[2]/this.moments[2]]}};function pE(i,t,e){let{permanent:n,separatrix:s,nutation:r}=e,[o,a]=n?[i.u0[0],i.u0[0]]:[h0(t.s1,t.t1),h0(t.s2,t.t2)],c={regime:mE(i,e),nutationLimits:i.reversed<0?[-a,-o]:[o,a],nutationPeriod:s?1/0:null,precessionPerPeriod:null,spinPerPeriod:null,precessionRate:null,spinRate:null};if(n||s)return c;let l=Tt(Nt(e.alpha,r),Ye(e.signAlpha)),h=Tt(Nt(e.beta,r),Ye(e.signBeta)),u=Nt(e.spin,r),d=st(En,Tt(l,h))[0],f=i.reversed*st(En,Tt(ie(l,h),u))[0],p=Nt(Jn(En,i.moments[0]),vt(r,i.rateScale))[0];return{...c,nutationPeriod:p,precessionPerPeriod:d,spinPerPeriod:f,precessionRate:d/p,spinRate:f/p}}var h0=(i,t)=>i[0]<t[0]?ie(Ne,i)[0]:ie(t,Ne)[0];function mE(i,t){let[e,n,s,r]=[i.momentum[2],i.c[0],i.cPlus[0],i.lean[0]];if(t.permanent&&e===0)return"rest";if(i.G[0]===0)return"free";if(t.permanent)return i.s0[0]===0?"sleeping":"hanging";if(t.separatrix)return"separatrix";if(t.steady)return"steady";if(e===0&&n===0)return"planar";let o=e<0?-r:r,a=n*e<0&&s*e>0;return a&&o===0?"cusp":a&&o>0?"loop":"undulating"}var u0=Math.PI/180,[gE,xE,_E]=[45,60,20],Yd="turns over and over",yE=.995,vE=!0,ME=["spin.tilt","spin.rate","spin.about"],SE={body:{moments:3},spin:Es};function bE({moments:i,momentum:t,attitude:e=[1,0,0,0],epoch:n=0,mass:s}){let r=t.map((a,c)=>a/i[c]),o=Ts(r);return{moments:i,velocity:r,attitude:e,epoch:n,about:o,around:tn(r,o).around,momentum:t,mass:s??1}}function wE(i){let t=d0(i);return[...t?[{key:"by",label:"set the body by",value:i.by??0,choices:[[0,"its moments"],[1,"the edges of a box"]]}]:[],...t&&i.by?AE(i,t):Rs(i.moments),...Cs(i)]}function AE({mass:i=1},t){let e=Math.max(...t),[n,s]=[["km",1e3],["m",1],["cm",.01],["mm",.001],["\xB5m",1e-6],["nm",1e-9]].find(([,r])=>e>=r)??["m",1];return[{key:"mass",label:"mass of the box",unit:"kg",value:i,log:!0,low:i/20,high:20*i},...t.map((r,o)=>({key:`edge.${o}`,label:`edge along axis ${o+1}`,unit:n,si:s,value:r,log:!0,low:Math.max(r,.001*e)/10,high:10*Math.max(r,.001*e)}))]}function d0({moments:i,mass:t=1}){let e=i[0]+i[1]+i[2],n=i.map(s=>6/t*(e-2*s));return n.every(s=>s>=0&&Number.isFinite(s))?n.map(Math.sqrt):null}function EE(i,t,e){let[n,s]=t.split(".");if(n==="by")return{...i,by:e};if(n!=="edge"&&n!=="mass")return Is(i,t,e);let r=d0(i),o=n==="mass"?e:i.mass??1;n==="edge"&&(r[Number(s)]=e);let a=r.map(l=>l*l),c=[0,1,2].map(l=>o/12*(a[(l+1)%3]+a[(l+2)%3]));return{...i,mass:o,moments:c,momentum:null}}function TE(i,t){let e=Math.hypot(...i.velocity.map((r,o)=>r*i.moments[o])),n=t.map(r=>r*e),s=n.map((r,o)=>r/i.moments[o]);return{...i,velocity:s,momentum:n,around:tn(s,i.about).around}}var RE=i=>new fi({moments:i.moments,momentum:Qn(i),attitude:i.attitude,epoch:i.epoch});function CE({moments:i,velocity:t,attitude:e}){return{body:{moments:i},spin:{angular_velocity:t,attitude:e}}}var IE=(i,t)=>Ps(i,t);function PE({moments:i,velocity:t,attitude:e},n){return`[body]
moments = ${On(i,"kg*m^2")}

[spin]
angular_velocity = ${On(t,"rad/s")}
attitude = [${e.map(Wt).join(", ")}]

[time]
until = "${Wt(n)} s"
`}function LE({moments:i,velocity:t},e){let n=jn(i),{period:s,regime:r}=e,o=s!==null&&Number.isFinite(s),a=f0(i,t,e,n),c=[["what it does",a]];return o&&c.push(["period of L in the body",Mn(s,s)]),o&&e.precessionPerPeriod!==null&&c.push(["precession about L",`${zt(e.precessionPerPeriod/u0,5)}\xB0 per period`]),a===Yd&&Number.isFinite(e.flipInterval??NaN)&&c.push(["turns over every",Mn(e.flipInterval,e.flipInterval)]),c.push(["regime",r]),c}function NE({moments:i,velocity:t},e){let{period:n,flipInterval:s}=e;return n===null||!Number.isFinite(n)?null:f0(i,t,e,jn(i))===Yd?s:n}function f0(i,t,{regime:e,modulus:n},s){if(e==="rest")return"at rest";if(e==="separatrix")return"runs up to the intermediate axis and stays there";if(e==="permanent"||e==="spherical")return"spins steadily";let[r,o]=DE(i,t,s),c=Number(r.toPrecision(3))===Number(o.toPrecision(3))?$d(o):`${$d(r)} to ${$d(o)}`;return o<gE?`cones, its axis ${c} from L`:o>=xE&&(o-r>=_E||n>yE)?Yd:`tumbles, its axis ${c} from L`}function $d(i){let[t,e]=[[1,"\xB0"],[.016666666666666666,"\u2032"],[.0002777777777777778,"\u2033"],[27777777777777776e-23," mas"]].find(([n])=>i>=n)??[1,"\xB0"];return`${zt(i/t,3)}${e}`}function DE(i,t,e){let[n,s,r]=e.map(m=>i[m]),o=e.map(m=>t[m]*i[m]),a=Math.hypot(...o),[c,l,h]=o.map(m=>Math.abs(m)/a),u=n===r||n*(r-s)*h*h>=r*(s-n)*c*c,d=u?n*(r-s)/(s*(r-n)):r*(s-n)/(s*(r-n)),f=u?c:h,p=Math.sqrt(f*f+(d||0)*l*l),g=Math.min(1,d>0?p/Math.sqrt(d):1);return n===r?[0,0]:[Math.asin(Math.min(p,g)),Math.asin(Math.max(p,g))].map(m=>m/u0)}var Jd={};as(Jd,{asSpec:()=>HE,changed:()=>GE,controls:()=>kE,facts:()=>$E,first:()=>UE,from:()=>FE,kept:()=>Mh,keys:()=>OE,make:()=>VE,spinAboutRotor:()=>_0,toml:()=>qE,withSpec:()=>WE});var m0=Math.PI/30,p0=Math.PI/180,UE=["rate","rotor","spin.tilt","spin.rate"],OE={body:{moments:3},system:{kind:0,rotor_axis:3,rotor_moment:1,rotor_rate:1,rotor_drive:0,rotor_momentum:1},spin:Es};function FE({moments:i,rotor:t,rotor_moment:e=null,rotor_drive:n="constant-rate",momentum:s,attitude:r=[1,0,0,0],epoch:o=0}){let a=s.map((d,f)=>(d-t[f])/i[f]),c=Ts(a),l=Math.hypot(...t),h=l>0?t.map(d=>d/l):[0,0,1],u=tn(a,c).around;return{moments:i,velocity:a,attitude:r,epoch:o,about:c,around:u,momentum:s,axis:h,spin:l,moment:e,drive:n}}var BE=1e-9,zE={momentum_space:"L in space"},yh=({axis:i,spin:t})=>i.map(e=>e*t),g0=({axis:i,drive:t,velocity:e})=>t==="free"?i.reduce((n,s,r)=>n+s*e[r],0):0,vh=i=>i.spin/i.moment-g0(i),x0=(i,t)=>({...i,spin:i.moment*(t+g0(i)),momentum:null});function kE(i){let t=Math.max(Math.abs(i.spin),Math.hypot(...Qn(i,yh(i))))||1;return[i.moment===null?{key:"rotor",label:"momentum of the rotor",unit:"kg m\xB2/s",value:i.spin,low:-2*t,high:2*t}:{key:"rate",label:"rotor speed against the body",unit:"rpm",si:m0,value:vh(i),low:-2*t/i.moment,high:2*t/i.moment},...Rs(i.moments),...Cs(i)]}function GE(i,t,e){return t==="rotor"?{...i,spin:e,momentum:null}:t==="rate"?x0(i,e):Is(i,t,e)}var VE=i=>new ba({moments:i.moments,rotor:yh(i),rotor_moment:i.moment,rotor_drive:i.drive,axis:i.axis,momentum:Qn(i,yh(i)),attitude:i.attitude,epoch:i.epoch}),HE=i=>({body:{moments:i.moments},system:i.moment===null?{kind:"gyrostat",rotor_axis:i.axis,rotor_momentum:i.spin}:{kind:"gyrostat",rotor_axis:i.axis,rotor_moment:i.moment,rotor_rate:vh(i),rotor_drive:i.drive},spin:{angular_velocity:i.velocity,attitude:i.attitude}});function WE(i,t){let{system:e={}}=t,n={...i};if(e.rotor_axis){let o=Math.hypot(...e.rotor_axis);if(!(o>0))throw new RangeError("system.rotor_axis must have a direction; got zeros.");Object.assign(n,{axis:e.rotor_axis.map(a=>a/o),momentum:null})}let s=e.rotor_rate??(n.moment===null?null:vh(n));if(e.rotor_moment!==void 0&&Object.assign(n,{moment:e.rotor_moment,momentum:null}),e.rotor_drive!==void 0&&Object.assign(n,{drive:e.rotor_drive,momentum:null}),e.rotor_momentum!==void 0&&Object.assign(n,{spin:e.rotor_momentum,momentum:null}),n=Ps(n,t,yh(n)),![e.rotor_rate,e.rotor_moment,e.rotor_drive].some(o=>o!==void 0))return n;if(n.moment===null)throw new RangeError("system.rotor_rate needs system.rotor_moment, the rotor's own moment of inertia.");return s===null?n:x0(n,s)}function qE(i,t){let{axis:e,moment:n,drive:s,velocity:r,attitude:o}=i,a=e.findIndex(l=>Math.abs(l)===1);if(n===null||s==="free"&&a<0)return null;let c=i.moments.map((l,h)=>s==="free"&&h===a?l+n:l);return`[body]
moments = ${On(c,"kg*m^2")}

[system]
kind = "gyrostat"
rotor_axis = [${e.map(Wt).join(", ")}]
rotor_moment = "${Wt(n)} kg*m^2"
rotor_rate = "${Wt(vh(i))} rad/s"
rotor_drive = "${s}"

[spin]
angular_velocity = ${On(r,"rad/s")}
attitude = [${o.map(Wt).join(", ")}]

[time]
until = "${Wt(t)} s"
`}var XE={minimum:"stable, also with losses in the body: least energy",maximum:"stable until losses act: most energy",saddle:"unstable: a saddle of the energy"};function $E(i,t){let e=t.state(t.epoch),n=Math.hypot(...e.momentum),s=Ta(e.attitude,e.momentum).map(o=>o/(n||1)),r=[];if(n>0){let{least:o,most:a,around:c}=mh(t,({attitude:h})=>Ta(h,i.axis),s);r.push(["rotor's axis leans from L",`${zt(o/p0,4)}\xB0 to ${zt(a/p0,4)}\xB0`]),r.push(["precession of the rotor's axis about L",`${zt(c/m0,4)} rpm`]);let l=_0(i,n);l&&(r.push(["a spin about the rotor's axis",XE[l.extremum]]),l.nutation&&r.push(["nutation: L goes round it in the body every",Mn(2*Math.PI/l.nutation,2*Math.PI/l.nutation)]))}return[...r,...Mh(t)]}function _0({moments:i,axis:t,spin:e},n){let s=t.findIndex(c=>Math.abs(Math.abs(c)-1)<BE);if(s<0)return null;let r=(n-e)/i[s],[o,a]=[1,2].map(c=>n/i[(s+c)%3]-r);return{extremum:o*a<=0?"saddle":o>0?"minimum":"maximum",nutation:o*a>0?Math.sqrt(o*a):null}}function Mh(i){let t=i.state(i.epoch),e=Math.hypot(...t.velocity)||1,n=i.state(i.epoch+40*Math.PI/e);return Object.entries(t.invariants).map(([s,r])=>{let[o,a]=[[r].flat(),[n.invariants[s]].flat()],c=Math.hypot(...o)||1;return[`${zE[s]??s}, change in 20 turns`,zt(Math.hypot(...o.map((l,h)=>l-a[h]))/c,2)]})}var jd={};as(jd,{asSpec:()=>nT,changed:()=>tT,controls:()=>QE,facts:()=>rT,first:()=>JE,from:()=>jE,keys:()=>KE,make:()=>eT,standsUpright:()=>M0,toml:()=>sT,withSpec:()=>iT});var y0=9.80665,[Kd,v0]=[Math.PI/180,Math.PI/30],YE=1e-5,ZE=.01*Kd,JE=["spin.rate","spin.tilt","mgl"],KE={system:{kind:0,moments:3,mgl:1,axis:3},spin:Es};function jE({moments:i,mgl:t,axis:e,momentum:n,attitude:s=[1,0,0,0],epoch:r=0}){let o=n.map((c,l)=>c/i[l]),a=Ts(o);return{moments:i,velocity:o,attitude:s,epoch:r,about:a,around:tn(o,a).around,momentum:n,mgl:t,axis:e}}var QE=i=>[{key:"mgl",label:"weight \xD7 distance to the centre of mass",unit:"N m",value:i.mgl,low:0,high:5*Math.abs(i.mgl)||1},...Rs(i.moments),...Cs(i)],tT=(i,t,e)=>t==="mgl"?{...i,mgl:e}:Is(i,t,e),eT=i=>new wa({...i,momentum:Qn(i)}),nT=({moments:i,mgl:t,axis:e,velocity:n,attitude:s})=>({system:{kind:"heavy-top",moments:i,mgl:t,axis:e},spin:{angular_velocity:n,attitude:s}});function iT(i,t){let{system:e={}}=t,n={...i};return e.mgl!==void 0&&(n.mgl=Number(e.mgl)),e.axis&&(n.axis=e.axis.map(Number)),Ps(n,e.moments?{...t,body:{moments:e.moments}}:t)}function sT(i,t){let{moments:e,mgl:n,axis:s,velocity:r,attitude:o}=i,a=Math.hypot(...s),c=s.map(g=>g/a),l=[0,1,2].map(g=>.5*(e[0]+e[1]+e[2])-e[g]),h=c.reduce((g,m,x)=>g+(m?m*m/l[x]:0),0);if(n&&!(h>0&&Number.isFinite(h)))return null;let u=n?.5/h:0,d=n?u*y0/n:0,f=n?n/(y0*d):1,p=[0,1,2].map(g=>[0,1,2].map(m=>(g===m?e[g]-u:0)+u*c[g]*c[m]));return`# a body with the moments ${e.map(g=>zt(g)).join(", ")} kg m\xB2 about its point, and mgl = ${zt(n)} N m
[body]
mass = "${Wt(f)} kg"
inertia = [${p.map(g=>On(g,"kg*m^2")).join(", ")}]

[system]
kind = "heavy-top"
pivot = ${On(c.map(g=>-d*g),"m")}

[spin]
angular_velocity = ${On(r,"rad/s")}
attitude = [${o.map(Wt).join(", ")}]

[time]
until = "${Wt(t)} s"
`}function rT({moments:i,mgl:t,axis:e,velocity:n},s){let r=Math.hypot(...e),o=e.map(f=>f/r),{least:a,most:c,swing:l,around:h}=mh(s,({attitude:f})=>Ta(f,o)),u=[["axis leans",`${zt(a/Kd,4)}\xB0 to ${zt(c/Kd,4)}\xB0`]];l!==null&&c-a>ZE&&u.push(["nutation: nods every",Mn(l,l)]),u.push(["mean precession",`${zt(h/v0,4)} rpm`]);let d=o.findIndex(f=>Math.abs(Math.abs(f)-1)<YE);if(d>=0){let f=n[d]*o[d];f&&t&&u.push(["a gyroscope's, mgl/I\u2083\u03C9",`${zt(t/(i[d]*f)/v0,4)} rpm`]),u.push(["upright at this spin, to first order",M0(i,t,d,f)?"stable: it would sleep":"unstable: it would fall"])}return[...u,...Mh(s)]}function M0(i,t,e,n){let[s,r,o]=[i[(e+1)%3],i[(e+2)%3],i[e]],[a,c]=[(o-r)*n*n-t,(o-s)*n*n-t],[l,h,u]=[s*r,s*c+r*a+((s+r-o)*n)**2,a*c];return h>0&&u>0&&h*h>4*l*u}var tf={};as(tf,{asSpec:()=>mT,changed:()=>fT,controls:()=>dT,facts:()=>yT,first:()=>lT,from:()=>uT,keys:()=>hT,make:()=>pT,toml:()=>xT,withSpec:()=>gT});var Sh=Math.PI/30,oT=Math.PI/180,S0=9.80665,aT=1e-6,cT=1e-9,lT=["lean","spin","precession"],hT={system:{kind:0,moments:3,mgl:1,lean:1},spin:{spin:1,precession:1,nutation_rate:1,lean:1,momentum:3,attitude:4}};function uT({moments:i,mgl:t,momentum:e,attitude:n=[1,0,0,0],epoch:s=0}){return{moments:i,mgl:t,...Qd(i,e,n),momentum:e,attitude:n,epoch:s}}function Qd(i,t,[e,n,s,r]){let o=t.map((p,g)=>p/i[g]),a=[2*(n*r-e*s),2*(s*r+e*n),e*e-n*n-s*s+r*r],c=Math.hypot(a[0],a[1]),l=2*Math.atan2(Math.hypot(n,s),Math.hypot(e,r));if(c<cT)return{lean:l<1?0:Math.PI,spin:o[2],precession:0,nutation:0,phi:2*Math.atan2(r,e),psi:0};let h=Math.atan2(r,e),u=Math.atan2(s,n),d=(o[0]*a[0]+o[1]*a[1])/c**2,f=(o[0]*a[1]-o[1]*a[0])/c;return{lean:l,precession:d,nutation:f,spin:o[2]-d*Math.cos(l),phi:h+u,psi:h-u}}function b0({moments:i,lean:t,spin:e,precession:n,nutation:s,phi:r,psi:o}){let[a,c]=[Math.cos(.5*t),Math.sin(.5*t)],[l,h]=[.5*(r+o),.5*(r-o)],u=[a*Math.cos(l),c*Math.cos(h),c*Math.sin(h),a*Math.sin(l)],d=[n*Math.sin(t)*Math.sin(o)+s*Math.cos(o),n*Math.sin(t)*Math.cos(o)-s*Math.sin(o),n*Math.cos(t)+e];return{attitude:u,momentum:d.map((f,p)=>f*i[p])}}function dT(i){let{moments:t,mgl:e,lean:n,spin:s,precession:r,nutation:o}=i,a=Math.max(Math.abs(s),Math.abs(r),Math.sqrt(Math.abs(e)/t[0]),1e-6),c={unit:"rpm",si:Sh,low:-5*a,high:5*a};return[{key:"moments.0",label:"moment of inertia across, at the point",unit:"kg m\xB2",value:t[0],log:!0,low:Math.max(t[0]/10,.5*t[2]),high:10*t[0]},{key:"moments.2",label:"moment of inertia about the axis",unit:"kg m\xB2",value:t[2],log:!0,low:t[2]/10,high:Math.min(10*t[2],2*t[0])},{key:"mgl",label:"weight \xD7 distance to the centre of mass",unit:"N m",value:e,low:0,high:5*Math.abs(e)||1},{key:"lean",label:"lean",unit:"\xB0",si:oT,value:n,low:0,high:Math.PI},{key:"spin",label:"spin about its axis",value:s,...c},{key:"precession",label:"precession at the start",value:r,...c},{key:"nutation",label:"nutation at the start",value:o,...c}]}function fT(i,t,e){let n={...i};return t==="moments.0"?n.moments=[e,e,i.moments[2]]:t==="moments.2"?n.moments=[i.moments[0],i.moments[1],e]:n[t]=e,{...n,...b0(n)}}function pT({moments:i,mgl:t,momentum:e,attitude:n,epoch:s}){return new Na({moments:i,mgl:t,momentum:e,attitude:n,epoch:s})}function mT({moments:i,mgl:t,attitude:e,lean:n,spin:s,precession:r,nutation:o}){return{system:{kind:"lagrange-top",moments:i,mgl:t,lean:n},spin:{spin:s,precession:r,nutation_rate:o,attitude:e}}}function gT(i,{system:t={},spin:e={}}){let n={...i};if(t.moments&&(n.moments=t.moments.map(Number)),t.mgl!==void 0&&(n.mgl=Number(t.mgl)),e.attitude){let o=e.attitude.map(Number),a=(e.momentum??i.momentum).map(Number);n={...n,...Qd(n.moments,a,o),attitude:o,momentum:a}}else if(e.momentum){let o=e.momentum.map(Number);return{...n,...Qd(n.moments,o,n.attitude),momentum:o}}let s={lean:t.lean??e.lean,spin:e.spin,precession:e.precession,nutation:e.nutation_rate},r=Object.entries(s).filter(([,o])=>o!==void 0);if(!r.length&&!t.moments)return n;for(let[o,a]of r)n[o]=Number(a);return{...n,...b0(n)}}function xT(i,t){let{moments:e,mgl:n,attitude:s,momentum:r}=i,o=.5*Math.min(.5*e[0],e[0]-.5*e[2]),a=o>0&&n?(n/S0)**2/o:1,c=n/(a*S0),l=e[0]-a*c*c,h=r.map((u,d)=>u/e[d]);return`# a body with these moments about its point, ${zt(e[0])} and ${zt(e[2])} kg m\xB2, and mgl = ${zt(n)} N m
[body]
mass = "${Wt(a)} kg"
moments = ["${Wt(l)} kg*m^2", "${Wt(l)} kg*m^2", "${Wt(e[2])} kg*m^2"]

[system]
kind = "lagrange-top"
pivot = ["0 m", "0 m", "${Wt(-c)} m"]

[spin]
angular_velocity = [${h.map(u=>`"${Wt(u)} rad/s"`).join(", ")}]
attitude = [${s.map(Wt).join(", ")}]

[time]
until = "${Wt(t)} s"
`}var _T={rest:"at rest",sleeping:"stands upright and spins",hanging:"hangs and spins",steady:"goes round at constant lean",free:"no weight: turns freely",planar:"swings like a pendulum",undulating:"nods while it goes round, always onward",cusp:"nods, halting at cusps",loop:"nods in loops",separatrix:"rises to the vertical and stays there"};function yT({moments:i,spin:t,mgl:e},n){let[s,r]=n.nutationLimits??[0,1],o=r-s<aT&&n.regime==="undulating"?"steady":n.regime,a=[["what it does",_T[o]??o]],c=n.nutationPeriod,l=c!==null&&Number.isFinite(c);return l&&o!=="steady"&&a.push(["nods every",Mn(c,c)]),l&&n.precessionPerPeriod!==null&&n.regime!=="planar"&&a.push(["mean precession",`${zt(n.precessionPerPeriod/c/Sh,4)} rpm`]),t&&e&&a.push(["a gyroscope's, mgl/I\u2083\u03C9",`${zt(e/(i[2]*t)/Sh,4)} rpm`]),e>0&&a.push(["sleeps upright from",`${zt(2*Math.sqrt(e*i[0])/i[2]/Sh,4)} rpm`]),a}var sf={};as(sf,{QuantumMotion:()=>Eh,asSpec:()=>$T,changed:()=>HT,controls:()=>VT,dragged:()=>BT,facts:()=>ZT,first:()=>zT,from:()=>GT,keys:()=>kT,make:()=>XT,withDirection:()=>WT,withSpec:()=>YT});var A0=2*Math.PI,vT=.5*(Math.sqrt(5)-1),MT=1-1e-15,E0=1e-12;function ST(i,t){let[e,n]=[1,Math.sqrt(1-t)],s=[];for(;e-n>E0*e;){let[a,c]=[.5*(e+n),.5*(e-n)];n=Math.sqrt(e*n),e=a,s.push(c/a)}let r=2**s.length*e*i;for(let a of s.reverse())r=.5*(r+Math.asin(a*Math.sin(r)));let o=Math.sin(r);return[o,Math.cos(r),Math.sqrt(1-t*o*o)]}function bT(i,t){let[e,n,s,r]=[1,Math.sqrt(1-t),i,1];for(;e-n>E0*e;){let o=Math.round(s/Math.PI)*Math.PI;s+=Math.atan(n/e*Math.tan(s-o))+o,[e,n,r]=[.5*(e+n),Math.sqrt(e*n),2*r]}return s/(r*e)}var ef=class{constructor([t,e,n],s,r){let[o,a,c]=r;this.unit=r,this.aboveSaddle=(t-e)*o*o>(e-n)*c*c;let l=(t-n)*o*o+(e-n)*a*a,h=(t-e)*a*a+(t-n)*c*c;if(!(h>0)||!(l>0)){this.rate=0;return}let[u,d]=this.aboveSaddle?[l,h]:[h,l],[f,p]=this.aboveSaddle?[t-e,e-n]:[e-n,t-e];this.m=Math.min(MT,p*d/(f*u)),this.rate=2*A0*s*Math.sqrt(f*u);let g=this.aboveSaddle?o:c;this.sign=g<0?-1:1,this.long=this.sign*Math.sqrt(u/(t-n)),this.middle=this.sign*Math.sqrt(d/f),this.short=Math.sqrt(d/(t-n)),this.phase=bT(Math.atan2(a/this.middle,(this.aboveSaddle?c:o)/this.short),this.m)}at(t){if(!this.rate)return this.unit;let[e,n,s]=ST(this.rate*t+this.phase,this.m),[r,o,a]=[this.long*s,this.middle*e,this.short*n];return this.aboveSaddle?[r,o,a]:[a,o,r]}};function T0(i,t,e,n){let s=Math.abs(e[0])<.6?[1,0,0]:[0,0,1],r=Da(w0(e,s)),o=w0(e,r);return Array.from({length:n},(a,c)=>{let l=((c+.5)/n)**(1/(4*t+1)),h=2*Math.asin(Math.sqrt(1-l)),u=A0*(c*vT%1),[d,f,p]=[Math.sin(h)*Math.cos(u),Math.sin(h)*Math.sin(u),Math.cos(h)];return new ef(i,t+.5,Da(e.map((g,m)=>d*r[m]+f*o[m]+p*g)))})}var w0=(i,t)=>[0,1,2].map(e=>i[(e+1)%3]*t[(e+2)%3]-i[(e+2)%3]*t[(e+1)%3]),Da=i=>i.map(t=>t/Math.hypot(...i));var wT=4,AT=1e-13,C0=(i,t,e,n,s)=>{let r=1-s;return i.clone().multiplyScalar(r*r*(1+2*s)).addScaledVector(t,s*s*(3-2*s)).addScaledVector(e,s*r*r).addScaledVector(n,-s*s*r)},R0=(i,t,e)=>i+e*(t-i);function I0(i,t,e,n,s){let r=p=>new C(...i.map((g,m)=>p.getComponent(m)/g)),[o,a]=[r(t.momentum),r(e.momentum)],c=(p,g)=>p.clone().cross(g).multiplyScalar(n),l=C0(t.momentum,e.momentum,c(t.momentum,o),c(e.momentum,a),s),h=ET(i,t.momentum,e.momentum,l,s);if(!t.attitude)return{momentum:h,attitude:null};let u=TT(t.attitude,e.attitude,o.multiplyScalar(n),a.multiplyScalar(n),s),d=t.momentum.clone().applyQuaternion(t.attitude);d.lerp(e.momentum.clone().applyQuaternion(e.attitude),s).normalize();let f=h.clone().applyQuaternion(u).normalize();return{momentum:h,attitude:new ae().setFromUnitVectors(f,d).multiply(u)}}function ET(i,t,e,n,s){let r=R0(t.length(),e.length(),s);if(!(r>0))return n;let o=Math.min(...i),a=new C(...i.map(u=>o/u)),c=u=>u.clone().multiply(a).dot(u),l=R0(c(t.clone().divideScalar(r)),c(e.clone().divideScalar(r)),s),h=n.clone().divideScalar(r);for(let u=0;u<wT;u++){let d=h.clone().multiply(a),[f,p,g]=[h.dot(h),h.dot(d),d.dot(d)],m=f*g-p*p;if(m<AT)return h.normalize().multiplyScalar(r);let[x,_]=[.5*(1-f),.5*(l-p)];h.addScaledVector(h.clone(),(x*g-_*p)/m).addScaledVector(d,(_*f-x*p)/m)}return h.multiplyScalar(r)}function TT(i,t,e,n,s){let r=i.clone().invert().multiply(t);r.w<0&&r.set(-r.x,-r.y,-r.z,-r.w);let o=new C(r.x,r.y,r.z),a=o.length(),c=2*Math.atan2(a,r.w),l=o.multiplyScalar(a>0?c/a:2),h=c>.001?1/c**2-1/(2*c*Math.tan(c/2)):1/12,u=l.clone().cross(n),d=n.clone().addScaledVector(u,.5).addScaledVector(l.clone().cross(u),h),f=C0(new C,l,e,d,s),p=f.length();return p>0?i.clone().multiply(new ae().setFromAxisAngle(f.divideScalar(p),p)):i.clone()}var RT=.08,CT=24e3,IT={f8:Float64Array,f4:Float32Array,u4:Uint32Array,u2:Uint16Array,u1:Uint8Array};function ue(i){if(!i)return null;let t=atob(i.data),e=new Uint8Array(t.length);for(let n=0;n<t.length;n++)e[n]=t.charCodeAt(n);return new IT[i.kind](e.buffer)}var bh=class{constructor(t){this.times=ue(t.times),this.attitudes=ue(t.attitude),this.momenta=ue(t.momentum),this.velocities=ue(t.velocity),this.energies=ue(t.energy),this.joined=t.joined,this.space=new ae(t.space[1],t.space[2],t.space[3],t.space[0]),this.count=this.times.length,this.fastest=PT(this.velocities),this.free=t.free,this.fine=this.finely()}finely(){if(!this.joined||!this.free||!this.momenta)return 1;let t=0;for(let n=1;n<this.count;n++)t=Math.max(t,this.times[n]-this.times[n-1]);let e=Math.ceil(this.fastest*t/RT);return Math.max(1,Math.min(e,Math.floor(CT/this.count)))}get states(){return this.dense??=Array.from({length:(this.count-1)*this.fine+1},(t,e)=>this.at(e/this.fine)),this.dense}get span(){return this.times[this.count-1]-this.times[0]}attitude(t){let[e,n,s,r]=this.attitudes.subarray(4*t,4*t+4);return new ae(n,s,r,e)}at(t){let e=Math.min(Math.floor(t),this.count-1),n=this.joined&&e+1<this.count?t-e:0,s=a=>n?a[e]+n*(a[e+1]-a[e]):a[e],r=a=>{if(!a)return null;let c=new C().fromArray(a,3*e);return n?c.lerp(new C().fromArray(a,3*e+3),n):c},o={position:e+n,time:s(this.times),attitude:this.attitudes?this.attitude(e):null,momentum:r(this.momenta),velocity:r(this.velocities),energy:this.energies?s(this.energies):null};return n&&this.free&&this.momenta?Object.assign(o,this.freely(e,n)):n&&this.attitudes&&o.attitude.slerp(this.attitude(e+1),n),o}freely(t,e){let[n,s]=[t,t+1].map(a=>({momentum:new C().fromArray(this.momenta,3*a),attitude:this.attitudes?this.attitude(a):null})),r=I0(this.free,n,s,this.times[t+1]-this.times[t],e),o=new C(...this.free.map((a,c)=>r.momentum.getComponent(c)/a));return{...r,velocity:this.velocities?o:null}}positionOf(t){let e=0,n=this.count-1;for(;n-e>1;){let r=e+n>>1;this.times[r]<=t?e=r:n=r}if(t>=this.times[n])return n;let s=this.times[n]-this.times[e];return e+(s>0?Math.max(0,(t-this.times[e])/s):0)}};function PT(i){let t=0;for(let e=0;i&&e<i.length;e+=3)t=Math.max(t,Math.hypot(i[e],i[e+1],i[e+2]));return t}var LT=2*Math.PI,wh=class{constructor({J:t,energies:e,vectors:n,kernel:s}){this.J=t,this.size=2*t+1,this.energies=e,this.middle=e.reduce((r,o)=>r+o,0)/this.size,this.vectors=ue(n),this.kernel=s}level(t){return{re:Float64Array.from({length:this.size},(e,n)=>this.vectors[n*this.size+t]),im:new Float64Array(this.size)}}coherent([t,e,n]){let{J:s,size:r}=this,[o,a]=[Math.atan2(Math.hypot(t,n),e),Math.atan2(t,n)],[c,l]=[Math.log(Math.cos(.5*o)),Math.log(Math.sin(.5*o))],[h,u]=[new Float64Array(r),new Float64Array(r)],d=0;for(let f=0;f<r;f++){let[p,g]=[2*s-f,s-f],m=.5*d+(p?p*c:0)+(f?f*l:0);h[f]=Math.exp(m)*Math.cos(g*a),u[f]=-Math.exp(m)*Math.sin(g*a),d+=Math.log((2*s-f)/(f+1))}return{re:h,im:u}}parts({re:t,im:e}){let{size:n,vectors:s}=this,[r,o]=[new Float64Array(n),new Float64Array(n)];for(let a=0;a<n;a++)for(let c=0;c<n;c++)r[c]+=s[a*n+c]*t[a],o[c]+=s[a*n+c]*e[a];return{x:r,y:o}}at({x:t,y:e},n){let{size:s,vectors:r}=this,[o,a]=[new Float64Array(s),new Float64Array(s)];for(let c=0;c<s;c++){if(t[c]===0&&e[c]===0)continue;let l=(this.energies[c]-this.middle)*n,h=LT*(l-Math.round(l)),[u,d]=[Math.cos(h),Math.sin(h)],[f,p]=[u*t[c]-d*e[c],d*t[c]+u*e[c]];for(let g=0;g<s;g++)o[g]+=r[g*s+c]*f,a[g]+=r[g*s+c]*p}return{re:o,im:a}}mean({re:t,im:e}){let{J:n,size:s}=this,[r,o,a]=[0,0,0];for(let c=0;c<s;c++){if(o+=(n-c)*(t[c]*t[c]+e[c]*e[c]),c+1===s)continue;let l=Math.sqrt((c+1)*(2*n-c));a+=l*(t[c]*t[c+1]+e[c]*e[c+1]),r+=l*(t[c]*e[c+1]-e[c]*t[c+1])}return[r/n,o/n,a/n]}};function NT(i,t){let[e,n]=[Math.cos(.5*t),Math.sin(.5*t)],s=Float64Array.of(1);for(let r=1;r<=2*i;r++){let o=new Float64Array((r+1)*(r+1));for(let a=0;a<=r;a++)for(let c=0;c<=r;c++){let l=0;a<r&&c<r&&(l+=e*Math.sqrt((r-a)*(r-c))*s[a*r+c]),a<r&&c>0&&(l-=n*Math.sqrt((r-a)*c)*s[a*r+c-1]),a>0&&c<r&&(l+=n*Math.sqrt(a*(r-c))*s[(a-1)*r+c]),a>0&&c>0&&(l+=e*Math.sqrt(a*c)*s[(a-1)*r+c-1]),o[a*(r+1)+c]=l/r}s=o}return s}function DT(i,t,e){let n=2*i+1,s=NT(i,t),r=s.map((c,l)=>c*e[l%n]),o=new Float64Array(n*(n+1)/2),a=0;for(let c=0;c<n;c++)for(let l=0;l+c<n;l++){let h=0;for(let u=0;u<n;u++)h+=r[l*n+u]*s[(l+c)*n+u];o[a++]=h}return o}var Ah=class{constructor(t,e,n){[this.J,this.rows,this.columns]=[t,n,2*n];let s=2*t+1;this.kernels=Array.from({length:n},(o,a)=>DT(t,(a+.5)*Math.PI/n,e));let r=o=>(o+.5)*2*Math.PI/this.columns;this.cosines=Array.from({length:s},(o,a)=>Float64Array.from({length:this.columns},(c,l)=>Math.cos(a*r(l)))),this.sines=Array.from({length:s},(o,a)=>Float64Array.from({length:this.columns},(c,l)=>Math.sin(a*r(l))))}of({re:t,im:e}){let{rows:n,columns:s}=this,r=2*this.J+1,[o,a]=[new Float64Array(r*(r+1)/2),new Float64Array(r*(r+1)/2)],c=0;for(let u=0;u<r;u++)for(let d=0;d+u<r;d++,c++){let f=u?2:1;o[c]=f*(t[d]*t[d+u]+e[d]*e[d+u]),a[c]=f*(t[d]*e[d+u]-e[d]*t[d+u])}let l=new Float32Array(n*s),h=new Float64Array(s);for(let u=0;u<n;u++){let d=this.kernels[u];h.fill(0);let f=0;for(let p=0;p<r;p++){let[g,m]=[0,0];for(let M=0;M+p<r;M++,f++)g+=d[f]*o[f],m+=d[f]*a[f];let[x,_]=[this.cosines[p],this.sines[p]];for(let M=0;M<s;M++)h[M]+=g*x[M]+m*_[M]}l.set(h,u*s)}return l}};var P0=Math.PI/180,Ri=-1,UT=400,OT=500,[L0,FT]=[[64,192],6],BT=!0,zT=["state.level","state.lean","state.towards"],kT={state:{level:1,direction:3}};function GT(i){let t=i.vectors?new wh(i):null;return{...i,spin:t,rotor:{map:null},level:i.level??Ri,first:i.direction}}function VT({spin:i,levels:t,level:e,direction:n}){let s=t.map(({name:c},l)=>[l,c]),r={key:"state.level",label:i?"state":"level",value:e,choices:i?[[Ri,"L as sharp as it can be"],...s]:s};if(e!==Ri)return[r];let{lean:o,towards:a}=nf(n);return[r,{key:"state.lean",label:"L leans from the b axis by",unit:"\xB0",si:P0,value:o,low:0,high:Math.PI},{key:"state.towards",label:"towards (0\xB0 is a, 90\xB0 is c)",unit:"\xB0",si:P0,value:a,low:-Math.PI,high:Math.PI}]}var nf=([i,t,e])=>({lean:Math.atan2(Math.hypot(i,e),t),towards:i||e?Math.atan2(e,i):0});function HT(i,t,e){if(t==="state.level")return N0(i,e);let{lean:n,towards:s}={...nf(i.direction),towards:i.towards??nf(i.direction).towards,[t.split(".")[1]]:e},r=[Math.sin(n)*Math.cos(s),Math.cos(n),Math.sin(n)*Math.sin(s)];return{...i,direction:r,towards:s,level:Ri}}function N0(i,t){let e=Number(t);if(e===Ri&&i.spin)return{...i,level:e};if(!Number.isInteger(e)||!i.levels[e])throw new RangeError(`state.level must be a whole number from 0 to ${i.levels.length-1}; got ${t}.`);return{...i,level:e,direction:i.levels[e].start}}function WT(i,t){if(i.level===Ri)return{...i,direction:t,towards:null};let e=o=>o.reduce((a,c,l)=>a+i.constants[l]*c*c,0),n=e(t),s=i.levels.map(({start:o})=>Math.abs(e(o)-n)),r=s.indexOf(Math.min(...s));return{...i,level:r,direction:qT(i.constants,i.levels[r].start,t)}}function qT([i,t,e],n,s){let r=i*n[0]**2+e*n[2]**2,o=r>t,[a,c]=o?[0,2]:[2,0],l=Math.sqrt((o?i-r:r-e)/(o?i-t:t-e)),h=Math.abs(n[c]);if(!(h>0)||!Number.isFinite(l))return n;let u=Math.atan2(s[1]/l,s[c]/h),d=[0,0,0];return[d[c],d[1]]=[h*Math.cos(u),Math.min(1,l)*Math.sin(u)],d[a]=(s[a]<0?-1:1)*Math.sqrt(Math.max(0,1-d[c]**2-d[1]**2)),Da(d)}var Eh=class extends fi{constructor({moments:t,constants:e,momentumSize:n,attitude:s,direction:r,level:o,levels:a,spin:c,rotor:l,J:h}){super({moments:t,momentum:r.map(u=>u*n),attitude:s,epoch:0}),[this.constants,this.spin,this.J,this.rotor]=[e,c,h,l],this.level=o===Ri?null:o,this.ladder=a,this.direction=r,this.parts=this.level===null?c.parts(c.coherent(r)):null,this.wanted=this.level===null?this.flipping():null}flipping(){let[t,e,n]=this.constants,s=4*Math.PI*(this.J+.5)*Math.sqrt((t-e)*(e-n)),r=Number.isFinite(this.period??NaN)?this.period:1/0,o=Math.min(3*r,2*(2*Math.log(this.J)+8)/s);return Number.isFinite(o)?o:null}spinAt(t){return this.parts?this.spin.at(this.parts,t):this.spin.level(this.level)}get map(){let t=Math.min(L0[1],Math.max(L0[0],FT*this.J));return this.rotor.map??=new Ah(this.J,this.spin.kernel,t),this.rotor.map}get cloud(){return this.members??=this.parts?T0(this.constants,this.J,this.direction,UT):[],this.members}plots(t){if(!this.parts)return null;let e=Math.max(1,Math.ceil(t.length/OT)),n=t.filter((l,h)=>h%e===0||h===t.length-1),s=Math.hypot(...this.state(0).momentum),r=n.map(l=>this.spin.mean(this.spinAt(l))),o=n.map(l=>this.state(l).momentum[1]/s),a=n.map(l=>this.meanOfCloud(l)[1]),c=(l,h)=>({name:l,times:n,values:h});return[{title:"L along the b axis, in |L|",unit:"",series:[{...c("quantum \u27E8L\u27E9",r.map(l=>l[1])),role:"motion"},{...c("one classical body",o),role:"classical"},{...c("mean of classical bodies",a),role:"ensemble"}]},{title:"quantum \u27E8L\u27E9 along the axes, in J",unit:"",along:!0,series:["a","b","c"].map((l,h)=>c(l,r.map(u=>u[h])))}]}meanOfCloud(t){let e=[0,0,0];for(let n of this.cloud)n.at(t).forEach((s,r)=>e[r]+=s);return e.map(n=>n/this.cloud.length*((this.J+.5)/this.J))}},XT=i=>new Eh(i),$T=({level:i,direction:t})=>({state:i===Ri?{direction:t}:{level:i}});function YT(i,{state:t={}}){if(t.direction){if(!i.spin)throw new RangeError(`state.direction asks for a state of a spin, which the page has up to J = ${i.largestJ}. Set state.level.`);if(!(Math.hypot(...t.direction)>0))throw new RangeError("state.direction must not be zero.");return{...i,level:Ri,direction:Da(t.direction),towards:null}}return t.level===void 0?i:N0(i,t.level)}function ZT({level:i,levels:t,constants:e,J:n,said:s,direction:r,first:o},a){if(i!==Ri)return t[i].said;let c=(n+.5)**2*r.reduce((u,d,f)=>u+e[f]*d*d,0),l=[["classical energy E/hc",`${zt(c/29979245800,7)} cm\u207B\xB9`]],{period:h}=a;return h!==null&&Number.isFinite(h)&&l.push(["classical L goes round its polhode in",Mn(h,h)]),r===o?[...l,...s]:l}var D0={DampedBody:Vd,EulerDisk:Wd,FreeMotion:Zd,Gyrostat:Jd,HeavyTop:jd,LagrangeMotion:tf,QuantumRotor:sf};var U0=.08,JT=8,[KT,jT]=[400,3e3],QT=24e3,rf=.5,Th=([i,t,e,n])=>new ae(t,e,n,i),Rh=class i{constructor(t,e=null,n=null){this.solver=t,this.moments=t.moments,this.free=t instanceof fi?t.moments:null,this.hasUp=t.mgl!==void 0||!!t.onPlane,this.endless=!0,this.joined=!0,this.times=e?.length?e:this.window(t.epoch),this.count=this.times.length,this.space=n?Th(n):this.upright(),this.fill(),this.fine=Math.max(1,Math.min(Math.ceil(this.fastest*this.span/(U0*(this.count-1||1))),Math.floor(QT/this.count)))}window(t){let e=this.solver.mgl?.1*Math.sqrt(Math.abs(this.solver.mgl)/Math.max(...this.moments)):0,n=Math.max(this.speedAt(t),e)||1,s=this.solver.wanted??tR(this.solver,n),r=Math.max(KT,Math.min(jT,Math.ceil(s*n/U0)+1));return Float64Array.from({length:r},(o,a)=>t+s*a/(r-1))}speedAt(t){return Math.hypot(...this.solved(t).velocity)}upright(){if(this.hasUp)return new ae;let{attitude:t,momentum:e}=this.solver.state(this.solver.epoch),n=new C(...e).applyQuaternion(Th(t));return n.length()>0?new ae().setFromUnitVectors(n.normalize(),new C(0,0,1)):new ae}fill(){this.attitudes=new Float64Array(4*this.count),this.momenta=new Float64Array(3*this.count),this.velocities=new Float64Array(3*this.count),this.energies=new Float64Array(this.count),this.fastest=0,this.dense=null;for(let t=0;t<this.count;t++){let{attitude:e,momentum:n,velocity:s,energy:r}=this.solved(this.times[t]);this.attitudes.set(e,4*t),this.momenta.set(n,3*t),this.velocities.set(s,3*t),this.fastest=Math.max(this.fastest,Math.hypot(...s)),this.energies[t]=r}}solved(t){let e=this.solver.state(t);if(e.velocity)return e;let n=e.momentum.map((l,h)=>l/this.moments[h]),s=.5*e.momentum.reduce((l,h,u)=>l+h*n[u],0),[r,o,a,c]=e.attitude;return{...e,velocity:n,energy:this.hasUp?s+this.solver.mgl*(r*r-o*o-a*a+c*c):s}}get states(){return this.dense??=Array.from({length:(this.count-1)*this.fine+1},(t,e)=>this.at(e/this.fine)),this.dense}get span(){return this.times[this.count-1]-this.times[0]}attitude(t){return Th(this.attitudes.subarray(4*t,4*t+4))}at(t){let e=Math.min(Math.floor(t),this.count-1),n=e+1<this.count?t-e:0,s=n?this.times[e]+n*(this.times[e+1]-this.times[e]):this.times[e];return{position:e+n,...this.solvedAt(s)}}solvedAt(t){let{attitude:e,momentum:n,velocity:s,energy:r}=this.solved(t);return{time:t,attitude:Th(e),momentum:new C(...n),velocity:new C(...s),energy:r}}positionOf(t){let e=this.span>0?(t-this.times[0])/this.span:0;return Math.min(this.count-1,Math.max(0,e*(this.count-1)))}around(t){let[e,n]=[this.times[0],this.times[this.count-1]];if(t>=e&&t<=n)return this;let s=t>n&&t<n+(1-rf)*this.span?n-rf*this.span:t-rf*this.span,r=this.span/(this.count-1),o=this.times.map((u,d)=>s+d*r),{w:a,x:c,y:l,z:h}=this.space;return new i(this.solver,o,[a,c,l,h])}};function tR(i,t){let e=JT*2*Math.PI/t,n=i.period??i.nutationPeriod??null;return n!==null&&Number.isFinite(n)?Math.max(e,Math.min(2.2*n,12*e)):e}var eR=3,Ua=i=>document.getElementById(i),Ch=class{constructor(t,e){this.kind=D0[t.solver],this.given=t,this.changed=e,this.setting=this.first=this.kind.from(t),this.solver=this.kind.make(this.setting);let n={first:Ua("controls"),more:Ua("more"),fold:Ua("folded")};this.controls=new nh(n,(s,r)=>this.move(s,r),s=>this.say(s)),this.show()}motion(t=null,e=null){return new Rh(this.solver,t,e)}get event(){return this.kind.event?.(this.setting,this.solver)??null}show(){let t=this.kind.controls(this.setting);this.controls.show(t,this.kind.first??t.slice(0,eR).map(({key:e})=>e)),ag(Ua("facts"),this.kind.facts(this.setting,this.solver))}take(t){let e=[this.solver,this.setting];try{this.solver=this.kind.make(t)}catch(s){return this.say(s.message),!1}this.say("");let n=String(t.moments)!==String(this.first.moments);this.setting=t;try{this.show(),this.changed(n)}catch(s){return[this.solver,this.setting]=e,this.show(),this.changed(String(this.setting.moments)!==String(this.first.moments)),this.say(s.message),!1}return!0}move(t,e){t===null?this.show():this.take(this.kind.changed(this.setting,t,e))}set(t){try{return nR(t,this.kind.keys),this.take(this.kind.withSpec(this.setting,t))}catch(e){return this.say(e.message),!1}}point(t){this.take(this.kind.withDirection(this.setting,t))}get isAsGiven(){return this.setting===this.first}reset(){this.take(this.first)}say(t){Ua("refused").textContent=t}get tables(){return this.isAsGiven?{}:this.kind.asSpec(this.setting)}toml(t){return this.kind.toml?.(this.setting,t)??null}};function nR(i,t){if(typeof i!="object"||i===null||Array.isArray(i))throw new RangeError("set takes tables like {spin: {rate: 12}}.");for(let[e,n]of Object.entries(i)){if(!t[e])throw new RangeError(`There is no table ${e} here; there are ${Object.keys(t).join(", ")}.`);if(typeof n!="object"||n===null)throw new RangeError(`${e} must be a table of keys and values.`);for(let[s,r]of Object.entries(n)){if(!(s in t[e]))throw new RangeError(`There is no key ${e}.${s} here; there are ${Object.keys(t[e]).join(", ")}.`);let o=t[e][s],a=[r].flat();if(!(o===0?typeof r=="string":a.length===o&&Array.isArray(r)===o>1)||o&&!a.every(l=>typeof l=="number"&&Number.isFinite(l))){let l=o===0?"a word":o===1?"a finite number":`${o} finite numbers in brackets`;throw new RangeError(`${e}.${s} must be ${l}; got ${JSON.stringify(r)}.`)}}}}var Ih=class{constructor(t,e){this.root=t,this.changed=e,this.large=0}take(t){this.types=t,this.root.dataset.count=String(t.length),[...this.root.children].forEach((e,n)=>e.querySelector(".enlarge").addEventListener("click",()=>this.enlarge(n,!0))),this.large=0,this.mark()}get named(){return this.large?this.types[this.large]:null}enlarge(t,e=!1){let n=typeof t=="number"?t:this.types.indexOf(t);return n<0?!1:(this.large=n,this.mark(),e&&this.root.children[n].querySelector("canvas").focus({preventScroll:!0}),this.changed(),!0)}mark(){[...this.root.children].forEach((t,e)=>t.classList.toggle("large",e===this.large))}},Ph=class{constructor(t){this.elements=t,window.addEventListener("resize",()=>this.release())}keep(){for(let t of this.elements){let{height:e}=t.getBoundingClientRect();e>parseFloat(t.style.minHeight||0)&&(t.style.minHeight=`${e}px`)}}release(){for(let t of this.elements)t.style.minHeight=""}};var O0=new mn,Lh=new C,Os=class extends ia{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new ee(t,3)),this.setAttribute("uv",new ee(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new ys(e,6,1);return this.setAttribute("instanceStart",new Xn(n,3,0)),this.setAttribute("instanceEnd",new Xn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new ys(e,6,1);return this.setAttribute("instanceColorStart",new Xn(n,3,0)),this.setAttribute("instanceColorEnd",new Xn(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new Yo(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new mn);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),O0.setFromBufferAttribute(e),this.boundingBox.union(O0))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new wn),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Lh.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Lh)),Lh.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Lh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};ft.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Gt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};_n.line={uniforms:pa.merge([ft.common,ft.fog,ft.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var Fs=class extends Yn{constructor(t){super({type:"LineMaterial",uniforms:pa.clone(_n.line.uniforms),vertexShader:_n.line.vertexShader,fragmentShader:_n.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var of=new ce,F0=new C,B0=new C,en=new ce,nn=new ce,Ci=new ce,af=new C,cf=new Qt,sn=new sa,z0=new C,Nh=new mn,Dh=new wn,Ii=new ce,Pi,sr;function k0(i,t,e){return Ii.set(0,0,-t,1).applyMatrix4(i.projectionMatrix),Ii.multiplyScalar(1/Ii.w),Ii.x=sr/e.width,Ii.y=sr/e.height,Ii.applyMatrix4(i.projectionMatrixInverse),Ii.multiplyScalar(1/Ii.w),Math.abs(Math.max(Ii.x,Ii.y))}function iR(i,t){let e=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,c=o;a<c;a++){sn.start.fromBufferAttribute(s,a),sn.end.fromBufferAttribute(r,a),sn.applyMatrix4(e);let l=new C,h=new C;Pi.distanceSqToSegment(sn.start,sn.end,h,l),h.distanceTo(l)<sr*.5&&t.push({point:h,pointOnLine:l,distance:Pi.origin.distanceTo(h),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function sR(i,t,e){let n=t.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,c=a.attributes.instanceStart,l=a.attributes.instanceEnd,h=Math.min(a.instanceCount,c.count),u=-t.near;Pi.at(1,Ci),Ci.w=1,Ci.applyMatrix4(t.matrixWorldInverse),Ci.applyMatrix4(n),Ci.multiplyScalar(1/Ci.w),Ci.x*=r.x/2,Ci.y*=r.y/2,Ci.z=0,af.copy(Ci),cf.multiplyMatrices(t.matrixWorldInverse,o);for(let d=0,f=h;d<f;d++){if(en.fromBufferAttribute(c,d),nn.fromBufferAttribute(l,d),en.w=1,nn.w=1,en.applyMatrix4(cf),nn.applyMatrix4(cf),en.z>u&&nn.z>u)continue;if(en.z>u){let M=en.z-nn.z,v=(en.z-u)/M;en.lerp(nn,v)}else if(nn.z>u){let M=nn.z-en.z,v=(nn.z-u)/M;nn.lerp(en,v)}en.applyMatrix4(n),nn.applyMatrix4(n),en.multiplyScalar(1/en.w),nn.multiplyScalar(1/nn.w),en.x*=r.x/2,en.y*=r.y/2,nn.x*=r.x/2,nn.y*=r.y/2,sn.start.copy(en),sn.start.z=0,sn.end.copy(nn),sn.end.z=0;let g=sn.closestPointToPointParameter(af,!0);sn.at(g,z0);let m=ql.lerp(en.z,nn.z,g),x=m>=-1&&m<=1,_=af.distanceTo(z0)<sr*.5;if(x&&_){sn.start.fromBufferAttribute(c,d),sn.end.fromBufferAttribute(l,d),sn.start.applyMatrix4(o),sn.end.applyMatrix4(o);let M=new C,v=new C;Pi.distanceSqToSegment(sn.start,sn.end,v,M),e.push({point:v,pointOnLine:M,distance:Pi.origin.distanceTo(v),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var co=class extends Yt{constructor(t=new Os,e=new Fs({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,c=e.count;o<c;o++,a+=2)F0.fromBufferAttribute(e,o),B0.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+F0.distanceTo(B0);let r=new ys(s,2,1);return t.setAttribute("instanceDistanceStart",new Xn(r,1,0)),t.setAttribute("instanceDistanceEnd",new Xn(r,1,1)),this}raycast(t,e){let n=this.material.worldUnits,s=t.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;Pi=t.ray;let o=this.matrixWorld,a=this.geometry,c=this.material;sr=c.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Dh.copy(a.boundingSphere).applyMatrix4(o);let l;if(n)l=sr*.5;else{let u=Math.max(s.near,Dh.distanceToPoint(Pi.origin));l=k0(s,u,c.resolution)}if(Dh.radius+=l,Pi.intersectsSphere(Dh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Nh.copy(a.boundingBox).applyMatrix4(o);let h;if(n)h=sr*.5;else{let u=Math.max(s.near,Nh.distanceToPoint(Pi.origin));h=k0(s,u,c.resolution)}Nh.expandByScalar(h),Pi.intersectsBox(Nh)!==!1&&(n?iR(this,e):sR(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(of),this.material.uniforms.resolution.value.set(of.z,of.w))}};var lo=class extends Os{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,n=new Float32Array(2*e);for(let s=0;s<e;s+=3)n[2*s]=t[s],n[2*s+1]=t[s+1],n[2*s+2]=t[s+2],n[2*s+3]=t[s+3],n[2*s+4]=t[s+4],n[2*s+5]=t[s+5];return super.setPositions(n),this}setColors(t){let e=t.length-3,n=new Float32Array(2*e);for(let s=0;s<e;s+=3)n[2*s]=t[s],n[2*s+1]=t[s+1],n[2*s+2]=t[s+2],n[2*s+3]=t[s+3],n[2*s+4]=t[s+4],n[2*s+5]=t[s+5];return super.setColors(n),this}setFromPoints(t){let e=t.length-1,n=new Float32Array(6*e);for(let s=0;s<e;s++)n[6*s]=t[s].x,n[6*s+1]=t[s].y,n[6*s+2]=t[s].z||0,n[6*s+3]=t[s+1].x,n[6*s+4]=t[s+1].y,n[6*s+5]=t[s+1].z||0;return super.setPositions(n),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var Uh=class extends co{constructor(t=new lo,e=new Fs({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};function G0(i,t=Math.PI/3){let e=i.index?i.toNonIndexed():i,n=e.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let v=0;v<s;v++)r[3*v+0]=n.getX(v),r[3*v+1]=n.getY(v),r[3*v+2]=n.getZ(v)}let o=Math.cos(t),a=(1+1e-10)*100,c=s/3,l=new Float64Array(c*3);for(let v=0;v<c;v++){let b=9*v,w=r[b+0],y=r[b+1],S=r[b+2],I=r[b+3],T=r[b+4],L=r[b+5],N=r[b+6],F=r[b+7],P=r[b+8],B=N-I,G=F-T,H=P-L,j=w-I,W=y-T,Y=S-L,tt=G*Y-H*W,gt=H*j-B*Y,wt=B*W-G*j,X=1/(Math.sqrt(tt*tt+gt*gt+wt*wt)||1);l[3*v+0]=tt*X,l[3*v+1]=gt*X,l[3*v+2]=wt*X}let h=new Int32Array(s),u=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,p=new Int32Array(d),g=0;for(let v=0;v<s;v++){let b=3*v,w=Math.trunc(r[b+0]*a),y=Math.trunc(r[b+1]*a),S=Math.trunc(r[b+2]*a),I=(Math.imul(w,73856093)^Math.imul(y,19349663)^Math.imul(S,83492791))&f;for(;;){let T=p[I];if(T===0){let N=3*g;u[N+0]=w,u[N+1]=y,u[N+2]=S,p[I]=g+1,h[v]=g++;break}let L=3*(T-1);if(u[L+0]===w&&u[L+1]===y&&u[L+2]===S){h[v]=T-1;break}I=I+1&f}}let m=new Int32Array(g+1);for(let v=0;v<s;v++)m[h[v]+1]++;for(let v=0;v<g;v++)m[v+1]+=m[v];let x=new Int32Array(s),_=m.slice(0,g);for(let v=0;v<c;v++){let b=3*v;x[_[h[b+0]]++]=v,x[_[h[b+1]]++]=v,x[_[h[b+2]]++]=v}let M=new Float32Array(s*3);for(let v=0;v<c;v++){let b=3*v,w=l[b+0],y=l[b+1],S=l[b+2];for(let I=0;I<3;I++){let T=b+I,L=h[T],N=0,F=0,P=0;for(let G=m[L],H=m[L+1];G<H;G++){let j=3*x[G],W=l[j+0],Y=l[j+1],tt=l[j+2];w*W+y*Y+S*tt>o&&(N+=W,F+=Y,P+=tt)}let B=1/(Math.sqrt(N*N+F*F+P*P)||1);M[3*T+0]=N*B,M[3*T+1]=F*B,M[3*T+2]=P*B}}return e.setAttribute("normal",new Ce(M,3,!1)),e}var H0=new C(0,1,0),lf=.995,rR=.6,Oh=2*Math.PI,Ki=64,W0=(i,t,e)=>new Fs({color:new Ot(i),linewidth:t,transparent:e<1,opacity:e,alphaToCoverage:!1});function Je(i,t,e,n=1){let s=new Uh(new lo,W0(t,e,n));return s.geometry.setPositions(i.length>3?i:[...i,...i]),s.frustumCulled=!1,s}var ji=(i,t,e=1)=>q0(new Or,i,t,e);function q0(i,t,e,n){return i.geometry.setAttribute("position",new Ce(Float32Array.from(t),3)),i.material=new ps({color:e,transparent:n<1,opacity:n}),i.frustumCulled=!1,i}function hf(i,t){i.geometry.instanceCount=Math.max(0,t),i.visible=t>0}function ho(i,t,e,n=1){if(e<=1)return q0(new Js,i,t,n);let s=new co(new Os,W0(t,e,n));return s.geometry.setPositions(i),s.frustumCulled=!1,s}var Qi=(i,t,e,n)=>i.joined?Je(t,e,n):rr(t,e,n);function ts(i,t,e){i.joined?hf(t,e):t.geometry.setDrawRange(0,e+1)}function rr(i,t,e){let n=new _e;n.setAttribute("position",new Ce(Float32Array.from(i),3));let s=new Vo(n,new Fr({color:t,size:e,sizeAttenuation:!1}));return s.frustumCulled=!1,s}function Li(i,t,e,n=1){let s=[];for(let r=0;r<=128;r++)s.push(i*Math.cos(Oh*r/128),i*Math.sin(Oh*r/128),t);return n>1?Je(s,e,n):ji(s,e)}function or(i,t){let e=new gn({color:i}),n=new Yt(new oi(t,t,1,16),e),s=new Yt(new ms(3*t,8*t,24),e),r=new he().add(n,s);return r.point=(o,a)=>{let c=Math.max(a-8*t,1e-6);r.visible=a>.001,n.scale.set(1,c,1),n.position.set(0,.5*c,0),s.position.set(0,a-4*t,0),r.quaternion.copy(new ae().setFromUnitVectors(H0,o.clone().normalize())),r.userData.tip=o.clone().normalize().multiplyScalar(a)},r}function Bs(i,t,e){let n=new Yt(new Dn(e,24,16),new ln({color:i})),s=new Yt(new Dn(1.35*e,24,16),new ln({color:t,side:1}));return new he().add(n,s)}function X0(i,t,e,n){let s=new Yt(new ms(.45*n,n,16),new ln({color:i}));return s.position.copy(t).multiplyScalar(1.003),s.quaternion.setFromUnitVectors(H0,e),s}var V0={stable:()=>new Dn(.045,20,14),unstable:()=>new Xo(.06),undecided:()=>new Wi(.075,.075,.075)};function $0(i,t,e,n){let s=new Yt(V0[t](),new ln({color:e})),r=new Yt(V0[t](),new ln({color:n,side:1}));r.scale.setScalar(1.3);let o=new he().add(s,r);return o.position.copy(i),o}var Oa=null;function oR(){if(Oa)return Oa;let i=new Uint8Array(4*Ki*Ki);for(let t=0;t<Ki;t++)for(let e=0;e<Ki;e++){let[n,s]=[2*e/(Ki-1)-1,2*t/(Ki-1)-1],r=Math.exp(-12*((n+.35)**2+(s-.45)**2)),o=.62+.3*Math.tanh(2.5*s)-.3*Math.exp(-18*(s+.1)**2),a=Math.round(255*Math.min(1,Math.max(.12,o+.5*r)));i.set([a,a,a,255],4*(Ki*t+e))}return Oa=new ri(i,Ki,Ki),Oa.needsUpdate=!0,Oa}function Y0(i,t,e,n,s=null,r=!1){let o=new _e;if(o.setAttribute("position",new Ce(Float32Array.from(i),3)),o.setIndex(new Ce(t,1)),s){let u=[...s].flatMap(d=>new Ot(d).toArray());o.setAttribute("color",new Ce(Float32Array.from(u),3))}let a=G0(o,rR),c={color:s?"#ffffff":e,vertexColors:!!s,side:2,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},l=r?new Jo({...c,matcap:oR()}):new gn(c),h=new Js(new Br(o,30),new ps({color:n,transparent:!0,opacity:.6}));return new he().add(new Yt(a,l),h)}function Z0(i,t,e){let n=new Wi(...i),s=new gn({color:t,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),r=new Js(new Br(n),new ps({color:e,transparent:!0,opacity:.6}));return new he().add(new Yt(n,s),r)}function Fa(i,t,e,n=1){let s=new gn({color:t,transparent:n<1,opacity:n,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),r=new Yt(new Dn(1,80,48),s);r.scale.set(...i);let o=new he().add(r);for(let a=0;a<3;a++){let c=[];for(let l=0;l<=128;l++){let h=[0,0,0];h[(a+1)%3]=i[(a+1)%3]*Math.cos(Oh*l/128),h[(a+2)%3]=i[(a+2)%3]*Math.sin(Oh*l/128),c.push(...h)}o.add(ji(c,e,.7))}return o.userData.mesh=r,o}function J0(i,t,e){let n=new _e,s=new Float32Array(3*Math.max(0,i.length-3));for(let a=0;a+5<i.length;a+=3)s.set(i.slice(a,a+6),3*a+3);n.setAttribute("position",new Ce(s,3));let r=new ln({color:t,transparent:!0,opacity:e,side:2,depthWrite:!1}),o=new Yt(n,r);return o.frustumCulled=!1,o.renderOrder=2,o}function uo(i){let t=new gn({color:i.sphere,transparent:!0,opacity:.8,depthWrite:!0}),e=new Yt(new Dn(lf,80,48),t);return e.renderOrder=1,e}function fo(i,t,e,n=4){let s=new oi(i,i,1e-4,96);s.rotateX(Math.PI/2);let r=new ln({color:e.plane,transparent:!0,opacity:.75,polygonOffset:!0,polygonOffsetFactor:2,polygonOffsetUnits:2}),o=new Yt(s,r),a=new he().add(o);for(let c=1;c<=n;c++)a.add(Li(i*c/n,0,e.ring));return a.position.set(0,0,t),a.userData.mesh=o,a}function K0(i){i.traverse(t=>{t.geometry?.dispose();for(let e of[t.material].flat())e?.dispose()})}var aR=17,cR=200,lR=2,Fh=class{constructor(t){this.view=t,this.renderer=new Zl({antialias:!0,alpha:!0,powerPreference:"low-power"}),this.renderer.setClearColor(0,0),this.size=[0,0]}draw(t,e,n){let s=Math.min(window.devicePixelRatio||1,lR),r=e.map(c=>[c.clientWidth,c.clientHeight]);this.fit(r.reduce((c,[l])=>c+l,0),Math.max(...r.map(([,c])=>c)),s);let o=0,a=t.map((c,l)=>{let[h,u]=r[l];return h&&u&&this.render(c,o,h,u),o+=h,o-h});t.forEach((c,l)=>this.copy(c,e[l],a[l],r[l],s,n))}render(t,e,n,s){let{renderer:r}=this;t.flat?dR(t.camera,t.flat,n/s):this.view.place(t.camera,t.target??Rd,t.radius,n/s),t.lamp.position.copy(t.camera.position).add(fR.clone().applyQuaternion(t.camera.quaternion)),t.lamp.target.position.copy(t.target??Rd),t.lamp.target.updateMatrixWorld(),r.setViewport(e,0,n,s),r.setScissor(e,0,n,s),r.setScissorTest(!0),r.render(t.scene,t.camera)}copy(t,e,n,[s,r],o,a){let[c,l]=[Math.round(s*o),Math.round(r*o)];if(!c||!l)return;(e.width!==c||e.height!==l)&&([e.width,e.height]=[c,l]);let h=e.getContext("2d"),u=this.renderer.domElement;h.clearRect(0,0,c,l),h.drawImage(u,n*o,u.height-l,c,l,0,0,c,l),this.write(t,h,c,l,o,a)}fit(t,e,n){let s=[Math.max(this.size[0],t),Math.max(this.size[1],e)];this.dots===n&&s[0]===this.size[0]&&s[1]===this.size[1]||([this.size,this.dots]=[s,n],this.renderer.setPixelRatio(n),this.renderer.setSize(...s,!1))}write(t,e,n,s,r,o){if(t.boxes=[],Math.min(n,s)<cR*r)return;e.font=`600 ${13*r}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle",e.lineJoin="round";let a=[];for(let{text:c,place:l,color:h}of t.labels()){let u=l.clone().project(t.camera),d=[e.measureText(c).width+4*r,aR*r],f=[.5*(1+u.x)*n,.5*(1-u.y)*s],p=uR(f,d,a,[n,s]);a.push(p);let[g,m]=[p[0]+.5*d[0],p[1]+.5*d[1]];e.lineWidth=4*r,e.strokeStyle=o.ground,e.strokeText(c,g,m),e.fillStyle=h,e.fillText(c,g,m)}t.boxes=a.map(c=>c.map(l=>l/r))}},j0=[[0,0],[1,0],[-1,0],[0,-1],[0,1],[1,-1],[-1,-1],[1,1],[-1,1]],hR=4;function uR([i,t],[e,n],s,[r,o]){let a=(h,u,d)=>Math.min(Math.max(h,0),Math.max(0,d-u)),c=([h,u])=>s.every(([d,f,p,g])=>h>=d+p||d>=h+e||u>=f+g||f>=u+n),l=null;for(let h=0;h<=hR;h++)for(let[u,d]of h?j0.slice(1):j0.slice(0,1)){let f=a(i-.5*e+h*u*.55*e,e,r),p=a(t-.5*n+h*d*.55*n,n,o);if(l??=[f,p],c([f,p]))return[f,p,e,n]}return[...l,e,n]}function dR(i,{wide:t,high:e,x:n=0},s){let r=Math.max(e,t/s)/Math.tan(th*Math.PI/360);i.position.set(n,0,r),i.up.set(0,1,0),i.aspect=s,i.near=r/2,i.far=2*r,i.lookAt(n,0,0),i.updateProjectionMatrix(),i.updateMatrixWorld()}var fR=new C(-2,3,1);function Bn(i,t){let e=new Fo,n=new ea(16777215,2.1*i.lamp);return e.add(new na(16777215,1.3*i.lamp),n,n.target),{scene:e,lamp:n,camera:ng(),radius:1.5,labels:()=>[],probe:()=>({}),...t}}function Q0(i,t,e){let n=t.center?"from the pivot towards the centre of mass":"third principal axis",s=Bn(e,{title:"Path of the axis",words:n,radius:1.4,target:new C(0,0,.12)}),{scene:r}=s,o=new C(...t.axis),a=i.solver?.nutationLimits??null,c=a?a.filter(p=>p!==null&&Math.abs(p)<1):t.limits;r.add(uo(e),Li(1,0,e.family));for(let p of c)r.add(Li(Math.sqrt(Math.max(0,1-p*p)),p,e.border,1.5));let l=new Float64Array(3*i.count);for(let p=0;p<i.count;p++)o.clone().applyQuaternion(i.attitude(p)).toArray(l,3*p);let h=Qi(i,l,e.motion,2.6),u=i.joined?ji(l,e.motion,.35):null,d=Bs(e.motion,e.ground,.035),f=or(e.momentum,.012);return f.position.set(0,0,1),f.point(new C(0,0,1),.32),r.add(h,d,f),u&&r.add(u),s.legend=[{color:e.motion,text:"axis"},...c.length?[{color:e.border,text:"limits of its tilt"}]:[]],s.update=p=>{d.position.copy(o).applyQuaternion(p.attitude),ts(i,h,Math.floor(p.position))},s.labels=()=>[{text:"up",color:e.momentum,place:new C(0,0,1.42)}],s.probe=()=>({point:d.position.toArray(),path:[...l],limits:c}),s}var[tx,pR,mR]=[.45,.14,1.2],uf=6,gR=.45,ex=new C(0,1,0);function nx(i,t,e){let n=new C(...i.solver?.axis||t.axis).normalize(),s=new he;for(let d=0;d<uf;d++){let f=new oi(tx,tx,pR,12,1,!1,2*Math.PI*d/uf,2*Math.PI/uf),p=new gn({color:e.rotor});d%2&&p.color.multiplyScalar(gR),s.add(new Yt(f,p))}let r=new ae().setFromUnitVectors(ex,n),o=n.clone().multiplyScalar(mR).toArray(),a=new he().add(s,Je([...o.map(d=>-d),...o],e.rotor,2)),c=xR(i,t),l=c&&_R(i.times,c),h=(d,{position:f})=>{let p=Math.min(Math.floor(f),d.length-2);return p<0?d[0]:d[p]+(f-p)*(d[p+1]-d[p])};return{object:a,turn:d=>{let f=l?h(l,d):0;s.quaternion.copy(r).multiply(new ae().setFromAxisAngle(ex,f))},rate:d=>c?h(c,d):null}}function xR(i,t){let e=i.solver;if(!e?.rotorRate)return ue(t.rates);if(e.rotorMoment===null)return null;let n=s=>[0,1,2].map(r=>i.velocities[3*s+r]);return Float64Array.from({length:i.count},(s,r)=>e.rotorRate(n(r))??0)}function _R(i,t){let e=new Float64Array(t.length);for(let n=1;n<t.length;n++)e[n]=e[n-1]+.5*(t[n]+t[n-1])*(i[n]-i[n-1]);return e}var yR=.035;function ix({cage:{radius:i,center:t}},e){let n=new he,s=new Zo({color:e.edge,specular:"#ffffff",shininess:60}),r=()=>new Yt(new $o(i,yR*i,12,96),s),[o,a]=[r(),r()];o.rotation.y=Math.PI/2;for(let l of[o,a])l.position.z=t;return n.add(o,a),{object:n,turn:l=>{let h=l.clone().normalize(),u=new C(0,0,1).cross(h),d=u.lengthSq()>1e-12?u.normalize():new C(0,1,0);n.quaternion.setFromRotationMatrix(new Qt().makeBasis(d,h.clone().cross(d),h)),n.updateMatrix()}}}var sx=2*Math.PI,rx=1200,vR=.35,MR=.02,SR=Math.PI/4;function ox(i,t,e,n=.22){let s=bR(i,t),r=[];for(let c=0;c<s.length;c+=3)r.push(new C().fromArray(s,c).angleTo(t));let[o,a]=[Math.min(...r),Math.max(...r)];return!(a>MR)||s.length<9?null:{object:new he().add(J0(s,e,n),Je(s,e,1.5)),halves:[o,a]}}function bR(i,t){let n=(Math.abs(t.z)<.9?new C(0,0,1):new C(1,0,0)).clone().cross(t).normalize(),s=t.clone().cross(n),r=[],[o,a]=[0,null],c=Math.max(1,Math.floor(i.length/3/(20*rx)));for(let d=0;d<i.length&&Math.abs(o)<sx;d+=3*c){let f=new C().fromArray(i,d),p=Math.atan2(f.dot(s),f.dot(n));a!==null&&(o+=Math.atan2(Math.sin(p-a),Math.cos(p-a))),a=p,r.push(...f.toArray())}let l=wR(r,Math.ceil(r.length/3/rx)),h=new C().fromArray(l,0).distanceTo(new C().fromArray(l,l.length-3)),u=AR(l);return Math.abs(o)>=sx-1e-9&&h<Math.max(vR,2)*u&&l.push(...l.slice(0,3)),l}function wR(i,t){if(t<=1)return i;let e=[];for(let n=0;n<i.length;n+=3*t)e.push(...i.slice(n,n+3));return e}function AR(i){let t=0;for(let e=3;e<i.length;e+=3)t+=Math.hypot(...[0,1,2].map(n=>i[e+n]-i[e-3+n]));return t/Math.max(1,i.length/3-1)}function df(i,t){if(!i.free||!i.momenta)return!1;for(let e=0;e<i.count;e++){let n=new C().fromArray(i.momenta,3*e);if(!(Math.atan2(n.clone().cross(t).length(),Math.abs(n.dot(t)))<SR))return!1}return!0}function ax(i,t,e){let n={space:[],body:[],axis:[]};for(let s=0;s<i.count;s++){let r=i.attitude(s);if(n.axis.push(...e.clone().applyQuaternion(r).applyQuaternion(i.space).toArray()),!i.velocities)continue;let o=new C().fromArray(i.velocities,3*s).multiplyScalar(t);n.body.push(...o.toArray()),n.space.push(...o.applyQuaternion(r).applyQuaternion(i.space).toArray())}return n}var ff=1.36,[ER,TR]=[.6,.85],cx=new C(0,0,-1);function hx(i,t,e){let n=RR(i.momenta),s=[],r=(l,h,u,d,f,p=1.1)=>s.push({entry:$r(l,u,h),text:l,arrow:or(u,d),lengthOf:f,label:p,from:null});if(i.momenta&&r("L","L",e.momentum,.02,l=>lx(i,l.momentum,l,ff/n),1.08),i.velocities&&r("\u03A9","\u03A9",e.velocity,.017,l=>lx(i,l.velocity,l,ff/i.fastest),1.16),t){let l=new C(...t),h=d=>l.clone().applyQuaternion(d.attitude).applyQuaternion(i.space),u=l.length();r("mg","weight mg",e.weight,.017,()=>cx.clone().multiplyScalar(ER)),s.at(-1).from=h,r("\u03C4","torque of the weight, dL/dt",e.torque,.017,d=>h(d).cross(cx).multiplyScalar(TR/u))}let o=l=>{for(let h of s){let u=h.lengthOf(l),d=bs(h.entry)&&Number.isFinite(u.lengthSq())?u.length():0;d>0?h.arrow.point(u,d):h.arrow.visible=!1,h.from&&h.arrow.position.copy(h.from(l))}},a=()=>s.filter(l=>l.arrow.visible).map(l=>({text:l.text,color:l.entry.color,place:l.arrow.userData.tip.clone().multiplyScalar(l.label).add(l.arrow.position)})),c=()=>Object.fromEntries(s.map(l=>[l.text,l.arrow.visible?{tip:l.arrow.userData.tip.toArray(),from:l.arrow.position.toArray()}:null]));return{objects:s.map(l=>l.arrow),entries:s.map(l=>l.entry),show:o,labels:a,probe:c}}var lx=(i,t,e,n)=>t.clone().applyQuaternion(e.attitude).applyQuaternion(i.space).multiplyScalar(Number.isFinite(n)?n:0),ux=i=>i.fastest?ff/i.fastest:0;function RR(i){let t=0;for(let e=0;i&&e<i.length;e+=3)t=Math.max(t,Math.hypot(i[e],i[e+1],i[e+2]));return t}var zs=1.22,CR={ground:0,post:-zs,hook:zs},IR=.4,PR=.35,LR=.06;function dx(i,t,e){let n=t.pivot&&i.solver?{...t,pivot:FR(i,t.pivot)}:t,s=Bn(e,{title:"The body in space",words:n.changed?"box or ellipsoid of the same inertia":n.shape,radius:n.pivot==="ground"?1.5:1.62});n.pivot||(s.target=new C(0,0,.08)),n.pivot==="ground"&&(s.target=new C(0,0,.42));let r=new he;r.quaternion.copy(i.space),s.scene.add(r);let o=BR(i,n,e);r.add(o);let a=n.rotor?nx(i,n.rotor,e):null;a&&(NR(o),o.add(a.object));let c=[0,1,2].map(x=>{let _=new C().setComponent(x,zs);return o.add(Je([0,0,0,..._.toArray()],e.axes[x],x===n.traced&&!n.along?2.5:1.5)),_}),l=e.axes[n.traced],u=(n.along?new C(...n.along):new C().setComponent(n.traced,1)).multiplyScalar(zs);n.along&&o.add(Je([0,0,0,...u.toArray()],l,2.5));let d=GR(i,u,l);r.add(d.object),n.pivot?s.scene.add(fo(n.pivot==="ground"?zs:.7,CR[n.pivot],e)):s.scene.add(Li(zs,0,e.ring)),n.pivot==="post"&&s.scene.add(Je([0,0,-zs,0,0,0],e.edge,5)),n.pivot==="hook"&&s.scene.add(Je([0,0,0,0,0,zs],e.edge,5));let f=hx(i,n.weight?DR(n,u):null,e),p=UR(i,u,n,l,e),g=n.cage&&!n.changed?ix(n,e):null;g&&s.scene.add(g.object);for(let x of f.objects)s.scene.add(x);for(let x of p)(x.inBody?o:s.scene).add(x.object);let m=null;return s.legend=[{color:l,text:n.along?"trace of the axis through the centre of mass":`trace of axis ${n.axes?.[n.traced]??n.traced+1}`},...f.entries,...p.map(({entry:x})=>x),...a?[{color:e.rotor,text:`rotor${OR(a.rate({position:0}))}`}]:[]],s.update=x=>{m=x,o.quaternion.copy(x.attitude),d.show(x.position),a?.turn(x),f.show(x),g?.turn(u.clone().applyQuaternion(x.attitude).applyQuaternion(i.space));for(let _ of p)_.object.visible=bs(_.entry)},s.labels=()=>[...c.map((x,_)=>({text:n.axes?.[_]??`${_+1}`,color:e.axes[_],place:x.clone().multiplyScalar(1.07).applyQuaternion(m.attitude).applyQuaternion(i.space)})),...f.labels()],s.probe=()=>(o.updateWorldMatrix(!0,!1),{matrix:[...o.matrixWorld.elements],axisTip:u.clone().applyMatrix4(o.matrixWorld).toArray(),trace:[...d.points].slice(0,3*(d.shown+1)),momentumTip:f.probe().L?.tip??null,vectors:f.probe(),cage:g?g.object.matrix.elements.slice():null,cones:Object.fromEntries(p.map(({entry:x,halves:_,object:M})=>[x.key,{halves:_,shown:M.visible}])),rotor:a?[...a.object.children[0].quaternion.toArray(),a.rate(m)]:null}),s}function NR(i){i.traverse(t=>{t.isMesh&&(Object.assign(t.material,{transparent:!0,opacity:PR,depthWrite:!1}),t.renderOrder=1)})}var DR=({weight:i},t)=>t.clone().normalize().multiplyScalar(i.center).toArray();function UR(i,t,e,n,s){if(!i.joined||!i.attitudes||i.count<3)return[];let o=[0,1,2].map(u=>new C().setComponent(u,1)).find(u=>df(i,u))??null,a=df(i,t.clone().normalize()),c=ax(i,ux(i),t),l=new C(0,0,1),h=o??t.clone().normalize();return c.body.length&&new C().fromArray(c.body).dot(h)<0&&h.negate(),[{key:"space cone",text:e.pivot?"cone of \u03A9 in space":"cone of \u03A9 about L (space cone)",rays:c.space,about:l,tint:s.herpolhode},{key:"body cone",text:"cone of \u03A9 in the body",rays:c.body,about:h,tint:s.bodyCone,inBody:!0},{key:"axis cone",text:"cone of the axis",rays:c.axis,about:l,tint:n}].flatMap(({key:u,text:d,rays:f,about:p,tint:g,inBody:m=!1})=>{let x=ox(f,p,g);return x?[{...x,inBody:m,entry:$r(u,g,d,u==="axis cone"?a:o!==null)}]:[]})}function OR(i){return i===null?", drawn at rest: its moment is not given":`, ${zt(i*30/Math.PI,4)} rpm against the body`}function FR(i,t){let e=[];for(let n=0;n<i.count;n++)e.push(new C(0,0,1).applyQuaternion(i.attitude(n)).z);return e.reduce((n,s)=>n+s,0)<0?"hook":t!=="ground"||Math.min(...e)<IR?"post":"ground"}function BR(i,t,e){let n=new he,s=t.changed&&i.free?kR(i.free):null;if(s&&t.round)return n.add(Fa(s.map(r=>.5*r),e.body,e.edge));if(t.changed&&!s&&i.moments&&(t={ellipsoid:i.moments.map(r=>1/Math.sqrt(r))}),s)return n.add(Z0(s,e.body,e.edge));if(t.surface){let r=ue(t.surface.vertices),o=zR(r),{faces:a,colors:c,shiny:l=!1,lines:h=[]}=t.surface;n.add(Y0(r.map(u=>u/o),ue(a),e.body,e.edge,ue(c),l));for(let{points:u,color:d,width:f}of h){let p=[...ue(u)].map(m=>m/o),g=`#${d.toString(16).padStart(6,"0")}`;n.add(f>1?Je(p,g,f):ji(p,g))}}else if(t.ellipsoid){let r=Math.max(...t.ellipsoid);n.add(Fa(t.ellipsoid.map(o=>o/r),e.body,e.edge))}return n}function zR(i){let t=0;for(let e=0;e<i.length;e+=3)t=Math.max(t,Math.hypot(i[e],i[e+1],i[e+2]));return t}function kR([i,t,e]){let n=[t+e-i,e+i-t,i+t-e],s=i+t+e;return n.some(r=>r<1e-9*s)?null:n.map(r=>2*Math.sqrt(r/s))}function GR(i,t,e){let n=[],s=[],r=c=>n.push(...t.clone().applyQuaternion(c).toArray()),o=null;for(let c=0;c<i.count;c++){let l=i.attitude(c);if(o&&i.joined){let h=Math.min(20,Math.ceil(o.angleTo(l)/LR));for(let u=1;u<h;u++)r(i.at(c-1+u/h).attitude)}r(l),s.push(n.length/3-1),o=l}let a={points:n,shown:0};return i.joined?(a.object=Je(n,e,2),a.show=c=>hf(a.object,a.shown=s[Math.floor(c)])):(a.object=rr(n,e,3),a.show=c=>a.object.geometry.setDrawRange(0,(a.shown=Math.floor(c))+1)),a}function fx(i,t,e){let n=i.at(0).momentum,{free:s}=i;if(!(n.length()>0))return Bn(e,{title:"Poinsot's ellipsoid",words:"at rest",update:()=>{},legend:[]});let r=.5*n.toArray().reduce((T,L,N)=>T+L*L/s[N],0),o=s.map(T=>1/Math.sqrt(T)),a=1/Math.max(...o),c={moments:s,energy:r},l=a*Math.sqrt(2*r)/n.length(),h=HR(i,c,a),u=Math.max(1.25*VR(h,l),.9),d=1.3,f=.5*(d-l),p=Bn(e,{title:"Poinsot's ellipsoid",words:"rolls without slipping on the plane across L",radius:Math.hypot(Math.max(u,1),d-f)*1.04,target:new C(0,0,f)}),g=new he;g.quaternion.copy(i.space);let m=Fa(o.map(T=>T*a),e.body,e.edge,.82);g.add(m);let x=fo(u,-l,e);p.scene.add(g,x);let _=WR(i,h),M=Qi(i,h,e.motion,3),v=Qi(i,_,e.herpolhode,2.5);m.add(M),g.add(v),i.joined&&g.add(ji(_,e.herpolhode,.45));let b=Bs(e.velocity,e.ground,.03),w=or(e.velocity,.012),y=or(e.momentum,.012),S=ji([0,0,-l,0,0,0],e.edge);g.add(b,w),p.scene.add(y,S),y.point(new C(0,0,1),d);let I=0;return p.legend=[{color:e.motion,text:"polhode"},{color:e.herpolhode,text:"herpolhode"},{color:e.velocity,text:"contact, \u2212\u03A9"}],p.update=T=>{let L=Math.floor(T.position*i.fine);m.quaternion.copy(T.attitude),b.position.copy(px(T.momentum,c,a)).applyQuaternion(T.attitude),w.point(b.position,b.position.length()),ts(i,M,L),ts(i,v,L),I=L},p.labels=()=>[{text:"L",color:e.momentum,place:new C(0,0,d+.12)}],p.probe=()=>{for(let T of[m,x,b])T.updateWorldMatrix(!0,!0);return{ellipsoid:[...m.userData.mesh.matrixWorld.elements],plane:[...x.matrixWorld.elements],contact:new C().setFromMatrixPosition(b.matrixWorld).toArray(),bodyMatrix:[...m.matrixWorld.elements],spaceMatrix:[...g.matrixWorld.elements],polhode:[...h],herpolhode:[..._],shown:I/i.fine}},p}function px(i,{moments:t,energy:e},n){let s=-n/Math.sqrt(2*e);return new C(...i.toArray().map((r,o)=>s*r/t[o]))}function VR(i,t){let e=0;for(let n=0;n<i.length;n+=3)e=Math.max(e,Math.hypot(i[n],i[n+1],i[n+2]));return Math.sqrt(Math.max(0,e*e-t*t))}function HR(i,t,e){let n=new Float64Array(3*i.states.length);return i.states.forEach(({momentum:s},r)=>px(s,t,e).toArray(n,3*r)),n}function WR(i,t){let e=new Float64Array(t.length);return i.states.forEach(({attitude:n},s)=>{new C().fromArray(t,3*s).applyQuaternion(n).toArray(e,3*s)}),e}var qR=.45,[Bh,ks]=[72,144],pf=1.32,XR=1.05,$R=2*Math.PI;function mx(i,t,e){let n=i.free??(i.solver?.mgl===void 0?i.solver?.moments:null);if(!n||t.families||!(i.at(0).momentum.length()>0))return null;let s=i.solver?.rotor??[0,0,0];if(Math.max(...n)<XR*Math.min(...n)&&!s.some(Boolean))return null;let r=new gn({color:e.energy,transparent:!0,opacity:qR,side:2,depthWrite:!1}),o=new Yt(ZR(),r);o.renderOrder=2,o.frustumCulled=!1;let a=$r("energy",e.energy,"ellipsoid of the same energy",!1),c=null;return{object:o,entry:a,show:h=>{if(o.visible=bs(a)&&h.momentum.length()>0,!o.visible)return!1;let u=YR(n,s,h.momentum);return String([u.axes,u.center])!==String(c&&[c.axes,c.center])&&JR(o.geometry,u),c=u,!0},probe:()=>({...c,shown:o.visible,corners:[...o.geometry.attributes.position.array]})}}function YR(i,t,e){let n=e.length(),s=e.toArray().reduce((r,o,a)=>r+(o-t[a])**2/i[a],0);return{axes:i.map(r=>Math.sqrt(s*r)/n),center:t.map(r=>r/n)}}function ZR(){let i=new _e;for(let t of["position","normal"])i.setAttribute(t,new Ce(new Float32Array(3*(Bh+1)*(ks+1)),3));return i}function JR(i,{axes:t,center:e}){let{position:n,normal:s}=i.attributes,r=!e.some(Boolean),o=[];for(let c=0;c<=Bh;c++)for(let l=0;l<=ks;l++){let[h,u]=[Math.PI*c/Bh,$R*l/ks],d=[Math.sin(h)*Math.cos(u),Math.sin(h)*Math.sin(u),Math.cos(h)],f=r?1/Math.hypot(...d.map((_,M)=>_/t[M])):0,p=d.map((_,M)=>r?Math.min(f,pf)*_:e[M]+t[M]*_),g=p.map((_,M)=>(_-e[M])/t[M]**2),m=Math.hypot(...g)||1,x=c*(ks+1)+l;n.setXYZ(x,...p.map(_=>lf*_)),s.setXYZ(x,...g.map(_=>_/m)),o.push(r?f<=pf:Math.hypot(...p)<=pf)}let a=[];for(let c=0;c<Bh;c++)for(let l=0;l<ks;l++){let h=c*(ks+1)+l,[u,d,f]=[h+1,h+ks+2,h+ks+1];[h,u,d,f][r?"some":"every"](p=>o[p])&&a.push(h,f,d,h,d,u)}i.setIndex(a),n.needsUpdate=!0,s.needsUpdate=!0}var KR=18,jR=1.012,gx=4,xx={stable:"stable",unstable:"border",undecided:"undecided"},[QR,t2]=[.8,.55],e2={stable:"stable",unstable:"unstable",undecided:"undecided"};function _x(i,t,e){let n=Bn(e,{title:t.title,words:t.words,radius:1.36}),{scene:s}=n,r=t.families?e.text:e.motion,o=uo(e);s.add(o);let a=i.free?i.at(0).momentum.toArray():null,[c,l]=a?[t.families?[]:Ig(i.free),Pg(i.free)]:t.changed&&i.solver?[Lg(i.moments,i.solver.rotor??[0,0,0],i.at(0).momentum.length()),[]]:[ue(t.family)??[],ue(t.separatrix)??[]];c.length&&s.add(ho(c,e.family,1));for(let{starts:M,axis:v}of t.families??[])s.add(ho(M.flatMap(b=>Ea(i.free,b)),e.axes[v],1,.75));l.length&&s.add(ho(l,e.border,1.8));let h=a&&Math.hypot(...a)>0?ir(i.free,a):null,u=h??n2(i),d=h?Je(h,r,3.2):Qi(i,u,r,2);if(s.add(d),h)for(let M of i2(i.free,h,r))s.add(M);let f=t.changed?null:t.measured;f&&s.add(rr(f.map(M=>jR*M),e.velocity,6));let p=Bs(r,e.ground,.035);s.add(p);let g=[0,1,2].map(M=>{let v=new C().setComponent(M,1.2);return s.add(Je([...new C().setComponent(M,1).toArray(),...v.toArray()],e.axes[M],2.5)),v}),m=i.free?Cg(i.free):t.equilibria??[];for(let{at:M,verdict:v}of m)s.add($0(new C(...M),v,e[xx[v]],e.ground));let x=mx(i,t,e);x&&s.add(x.object);let _=[...new Set(m.map(({verdict:M})=>M))];return n.legend=[{color:r,text:"this motion"},...f?[{color:e.velocity,text:"measured"}]:[],...l.length?[{color:e.border,text:"separatrix"}]:[],...c.length?[{color:e.family,text:t.legend}]:[],...(t.families??[]).map(({axis:M,legend:v})=>({color:e.axes[M],text:v})),..._.map(M=>({color:e[xx[M]],text:e2[M]})),...x?[x.entry]:[]],n.update=M=>{let v=M.momentum.length();p.visible=v>0,v>0&&p.position.copy(M.momentum).divideScalar(v),h||ts(i,d,Math.floor(M.position*i.fine)),o.material.opacity=x?.show(M)?t2:QR},n.labels=()=>g.map((M,v)=>({text:t.axes?.[v]??`L${"\u2081\u2082\u2083"[v]}`,color:e.axes[v],place:M.clone().multiplyScalar(1.08)})),n.grasp=([M,v],b)=>{let w=p.position.clone().project(n.camera),y=p.position.dot(n.camera.position)>1;return i.free&&y&&Math.hypot(w.x-M,w.y-v)*.5*b<KR},n.under=M=>s2(M,n.camera),n.probe=()=>({point:p.position.toArray(),path:[...u],closed:!!h,measured:f,surface:x?.probe()??null,seen:p.position.clone().project(n.camera).toArray()}),n}function n2(i){let t=new Float64Array(3*i.states.length);return i.states.forEach(({momentum:e},n)=>e.clone().normalize().toArray(t,3*n)),t}function i2(i,t,e){let n=[],s=t.length/3-1;for(let r=0;r<gx;r++){let o=new C().fromArray(t,3*Math.round((r+.5)/gx*s)),a=o.clone().cross(new C(...o.toArray().map((c,l)=>c/i[l])));a.length()>0&&n.push(X0(e,o,a.normalize(),.085))}return n}function s2([i,t],e){let n=e.position.clone(),s=new C(i,t,.5).unproject(e).sub(n).normalize(),r=-n.dot(s),o=n.clone().addScaledVector(s,r),a=o.lengthSq();return a>=1?o.lengthSq()>0?o.normalize().toArray():null:n.addScaledVector(s,r-Math.sqrt(1-a)).normalize().toArray()}var mf={palette:["#0072B2","#E69F00","#009E73","#D55E00","#56B4E9","#CC79A7"],light:{ground:"#ffffff",text:"#222222",motion:"#0072B2",border:"#D55E00",stable:"#009E73",undecided:"#6f6f6f",family:"#6f6f6f",velocity:"#a8477c",momentum:"#222222",weight:"#6f6f6f",torque:"#6b4fc8",herpolhode:"#a8477c",bodyCone:"#56B4E9",energy:"#d9b800",rotor:"#8c5a2b",ensemble:"#E69F00",classical:"#6f6f6f",axes:["#0072B2","#c78500","#009E73"],sphere:"#eef1f4",body:"#b9c6d3",edge:"#5a6672",plane:"#dfe4e8",ring:"#b4bcc4"},dark:{ground:"#14171b",text:"#e6e6e6",motion:"#56B4E9",border:"#f0803c",stable:"#1fbf92",undecided:"#a0a7ae",family:"#7d848c",velocity:"#CC79A7",momentum:"#f2f2f2",weight:"#a0a7ae",torque:"#a692f0",herpolhode:"#CC79A7",bodyCone:"#9ad4f5",energy:"#F0E442",rotor:"#d29a62",ensemble:"#E69F00",classical:"#a0a7ae",axes:["#56B4E9","#E69F00","#1fbf92"],sphere:"#2a3038",body:"#66727f",edge:"#aab4be",plane:"#2a3038",ring:"#4c5660"}};var Gs={light:{...mf.light,name:"light",lamp:1},dark:{...mf.dark,name:"dark",lamp:1.1}},yx=[[],[6,3],[2,2],[8,3,2,3]];function gf(i,t){let e=[i.motion,i.axes[1],i.stable,i.border,i.bodyCone,i.velocity];return{color:e[t%e.length],dash:yx[Math.floor(t/e.length)%yx.length]}}var o2=1600,a2=.05,ye={left:62,right:12,top:10,bottom:24},po=180/Math.PI,vx=[[1/po,"\xB0"],[1/po/60,"\u2032"],[1/po/3600,"\u2033"],[.001/po/3600,"mas"]];function c2(i,t,e,n){let s=i.solver?.plots?.(n.map(h=>i.times[h])),r=(h,u,d)=>h.role?{color:e[h.role]}:d?{color:e.axes[u]}:gf(e,u);if(s)return s.map(({series:h,along:u,...d})=>({...d,series:h.map((f,p)=>({...f,...r(f,p,u)}))}));let o=[],a=i.velocities??i.momenta,c=t.axes??["axis 1","axis 2","axis 3"];a&&o.push({title:i.velocities?"\u03A9 along the body's axes":"L along the body's axes",unit:i.velocities?"rad/s":"kg m\xB2/s",series:c.map((h,u)=>({name:h,color:e.axes[u],values:n.map(d=>a[3*d+u])}))});let l=l2(i,t,e,n,c);l&&o.push(l);for(let{title:h,unit:u,series:d}of t.plots??[])o.push({title:h,unit:u,series:d.map(({name:f,values:p},g)=>{let m=ue(p);return{name:f,...gf(e,g),values:n.map(x=>m[x])}})});return o}function l2(i,t,e,n,s){if(!i.attitudes)return null;if(t.up==="L"&&i.momenta){let a=(l,h)=>{let u=i.momenta.subarray(3*l,3*l+3);return Math.atan2(Math.hypot(u[(h+1)%3],u[(h+2)%3]),u[h])*po};return{title:"angles of the axes from L",unit:"\xB0",series:s.map((l,h)=>({name:l,color:e.axes[h],values:n.map(u=>a(u,h))}))}}let r=new C(...t.panels.find(a=>a.axis)?.axis??[0,0,1]).normalize(),o=a=>{let[c,l,h,u]=i.attitudes.subarray(4*a,4*a+4),d=r.clone().applyQuaternion(new ae(l,h,u,c));return Math.atan2(Math.hypot(d.x,d.y),d.z)*po};return{title:"tilt of the axis from the vertical",unit:"\xB0",series:[{name:"tilt",color:e.motion,values:n.map(o)}]}}var zh=class{constructor(t,e){this.root=t,this.goTo=e,this.plots=[]}take(t,e,n){this.motion=t,this.theme=n;let s=Math.max(1,Math.ceil(t.count/o2)),r=[];for(let c=0;c<t.count;c+=s)r.push(c);r.at(-1)!==t.count-1&&r.push(t.count-1),this.times=r.map(c=>t.times[c]);let o=t.count>1&&t.span>0?c2(t,e,n,r).map(m2):[];for(let{title:c,words:l,x:h,y:u}of e.scatters??[])o.push({title:c,words:l,scatter:[ue(h),ue(u)],color:n.motion});let a=h2(t,n);a&&o.push(a),o.length!==this.plots.length&&(this.root.replaceChildren(...o.map(()=>this.frame())),this.plots=o.map((c,l)=>({figure:this.root.children[l],canvas:this.root.children[l].firstChild}))),this.plots.forEach((c,l)=>{c.what=o[l],c.still=null,f2(c.figure,o[l])})}frame(){let t=document.createElement("figure");t.className="plot";let e=document.createElement("canvas");e.setAttribute("role","img");let n=s=>{if(!this.plots.find(c=>c.canvas===e).what.series||s.type==="pointermove"&&!s.buttons)return;let o=e.getBoundingClientRect(),a=(s.clientX-o.left-ye.left)/(o.width-ye.left-ye.right);this.goTo(this.times[0]+Math.min(1,Math.max(0,a))*(this.times.at(-1)-this.times[0]))};return e.addEventListener("pointerdown",n),e.addEventListener("pointermove",n),t.append(e,document.createElement("figcaption")),t}draw(t){for(let e of this.plots){let{canvas:n,what:s}=e,r=Math.min(window.devicePixelRatio||1,2),[o,a]=[n.clientWidth,n.clientHeight];if(!o||!a)continue;(!e.still||e.width!==o||e.dots!==r)&&(Object.assign(e,{width:o,dots:r,still:this.still(s,o,a,r)}),[n.width,n.height]=[e.still.width,e.still.height]);let c=n.getContext("2d");c.clearRect(0,0,n.width,n.height),c.drawImage(e.still,0,0),c.setTransform(r,0,0,r,0,0),s.path?this.dot(c,s,t,o,a):s.series&&this.cursor(c,t,o,a),c.setTransform(1,0,0,1,0,0)}}still(t,e,n,s){let r=document.createElement("canvas");[r.width,r.height]=[Math.round(e*s),Math.round(n*s)];let o=r.getContext("2d");return o.scale(s,s),o.font="12px system-ui, sans-serif",t.path?d2(o,t,e,n,this.theme):t.scatter?u2(o,t,e,n,this.theme):this.drawCurves(o,t,e,n),r}drawCurves(t,{series:e,unit:n,power:s},r,o){let{times:a,theme:c}=this,[l,h]=xf(e),u=Sx(a[0],a.at(-1),l,h,r,o);t.fillStyle=c.text,t.strokeStyle=c.ring,t.textBaseline="middle",t.textAlign="right";for(let g of kh(l,h,4)){let[,m]=u(a[0],g);mo(t,[[ye.left,m],[r-ye.right,m]]),t.fillText(`${Ba(g/10**s)}${n==="\xB0"?"\xB0":""}`,ye.left-6,m)}t.textBaseline="top",t.textAlign="center";let d=a.at(-1)-a[0],[f,p]=kd(d)??[1,"s"];for(let g of kh(a[0]/f,a.at(-1)/f,r>500?6:3))t.fillText(`${Ba(g)} ${p}`,u(g*f,l)[0],o-ye.bottom+7);for(let{color:g,dash:m=[],values:x,times:_=a}of e){[t.strokeStyle,t.fillStyle,t.lineWidth]=[g,g,1.6],t.setLineDash(m);let M=x.map((v,b)=>u(_[b],v));if(this.motion.joined)mo(t,M);else for(let[v,b]of M)t.fillRect(v-1,b-1,2,2)}t.setLineDash([])}cursor(t,e,n,s){let[r,o]=[this.times[0],this.times.at(-1)],a=ye.left+(e.time-r)/(o-r||1)*(n-ye.left-ye.right);t.strokeStyle=this.theme.text,t.lineWidth=1.2,mo(t,[[a,ye.top],[a,s-ye.bottom]])}dot(t,e,n,s,r){let[o,a]=Mx(e,s,r)(e.flat(n.momentum.clone().normalize()));t.fillStyle=this.theme.velocity,t.beginPath(),t.arc(o,a,5,0,2*Math.PI),t.fill()}probe(){return this.plots.map(({what:t})=>({title:t.title,ranges:(t.series??[]).map(({values:e})=>[Math.min(...e),Math.max(...e)]),styles:(t.series??[]).map(({color:e,dash:n=[]})=>({color:e,dash:n})),across:t.across??null}))}};function h2(i,t){if(!i.free)return null;let e=i.at(0).momentum;if(!(e.length()>0))return null;let n=ir(i.free,e.toArray()),s=e.clone().normalize().toArray(),r=s.reduce((f,p,g)=>Math.abs(p)>Math.abs(s[f])?g:f,0);if(!n)return null;let o=Math.sign(s[r]),a=f=>[f.getComponent((r+1)%3)*o,f.getComponent((r+2)%3)],c=[];for(let f=0;f<n.length;f+=3)c.push(a(new C(n[f],n[f+1],n[f+2])));let l=Math.max(...c.map(([f,p])=>Math.hypot(f,p)));if(!(l<a2)||l<1e-14)return null;let[h,u]=vx.find(([f])=>2*l>=f)??vx.at(-1),d=`${Ba(2*l/h,3)}${u.length>1?" ":""}${u}`;return{title:`the polhode from above, ${d} across: the sphere magnified ${zt(1/l,1)} times`,across:d,path:c,flat:a,most:l,color:t.motion,unit:h,name:u}}var Mx=({most:i},t,e)=>{let n=(.5*Math.min(t,e)-22)/i;return([s,r])=>[.5*t+n*s,.5*e-n*r]};function u2(i,{scatter:[t,e],color:n},s,r,o){let[[a,c],[l,h]]=[t,e].map(f=>xf([{values:f}])),u=Sx(a,c,l,h,s,r);[i.fillStyle,i.textBaseline,i.textAlign]=[o.text,"middle","right"];for(let f of kh(l,h,4))i.fillText(Ba(f),ye.left-6,u(a,f)[1]);[i.textBaseline,i.textAlign]=["top","center"];for(let f of kh(a,c,6))i.fillText(Ba(f),u(f,l)[0],r-ye.bottom+7);i.strokeStyle=o.ring,i.strokeRect(ye.left,ye.top,s-ye.left-ye.right,r-ye.top-ye.bottom),i.fillStyle=n;let d=t.length<500?3:1.6;for(let f=0;f<t.length;f++){let[p,g]=u(t[f],e[f]);i.fillRect(p-.5*d,g-.5*d,d,d)}}function d2(i,t,e,n,s){let r=Mx(t,e,n);i.strokeStyle=s.ring,mo(i,[[.5*e-8,.5*n],[.5*e+8,.5*n]]),mo(i,[[.5*e,.5*n-8],[.5*e,.5*n+8]]),[i.strokeStyle,i.lineWidth]=[t.color,2],mo(i,t.path.map(r))}function f2(i,{title:t,words:e="",unit:n,series:s,path:r,power:o}){let a=document.createElement("strong"),c=o?`10${[...String(o)].map(d=>zd[d]).join("")} `:"";a.textContent=n&&!r?`${t} [${c}${n}]`:t;let l=document.createElement("span");l.className="legend";for(let{name:d,color:f,dash:p=[]}of s?.length>1?s:[]){let[g,m]=[document.createElement("span"),document.createElement("i")];m.style.background=p2(f,p),g.append(m,d),l.append(g)}let h=document.createElement("span");h.className="words",h.textContent=e,i.lastChild.replaceChildren(a,h,l);let u=r?", with the point that moves":s?", over time":"";i.firstChild.setAttribute("aria-label",`${a.textContent}${e?`, ${e}`:""}${u}.`)}function p2(i,t){if(!t.length)return i;let e=0;return`repeating-linear-gradient(90deg, ${t.map((s,r)=>{let[o,a]=[e,e+=s];return`${r%2?"transparent":i} ${o}px ${a}px`}).join(", ")})`}function m2(i){let t=Math.max(...xf(i.series).map(Math.abs)),e=i.unit==="\xB0"||!(t>0)||t>=.01&&t<1e4;return{...i,power:e?0:Math.floor(Math.log10(t))}}var Ba=(i,t=6)=>String(Number(i.toPrecision(t))).replace("-","\u2212");function xf(i){let[t,e]=[1/0,-1/0];for(let{values:s}of i)for(let r of s)t=Math.min(t,r),e=Math.max(e,r);let n=e-t>1e-9*Math.max(Math.abs(t),Math.abs(e))?.06*(e-t):.5*Math.abs(e)||1;return[t-n,e+n]}function Sx(i,t,e,n,s,r){let[o,a]=[s-ye.left-ye.right,r-ye.top-ye.bottom];return(c,l)=>[ye.left+(c-i)/(t-i||1)*o,ye.top+(n-l)/(n-e)*a]}function kh(i,t,e){let n=(t-i)/e,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].find(a=>a*s>=n)*s,o=[];for(let a=Math.ceil(i/r);a*r<=t;a++)o.push(a*r);return o}function mo(i,t){i.beginPath(),t.forEach(([e,n],s)=>s?i.lineTo(e,n):i.moveTo(e,n)),i.stroke()}var za=i=>document.getElementById(i),Gh=class{constructor(t,e,n){this.presets=t,this.act=n,za("playground").hidden=!1,document.documentElement.dataset.playground="",this.buttons=t.map((s,r)=>{let o=document.createElement("button");return Object.assign(o,{type:"button",textContent:s.title}),o.addEventListener("click",()=>e(this.choose(r))),o}),za("presets").replaceChildren(...this.buttons)}find(t){let e=this.presets.findIndex(({key:o})=>o===t),n=this.choose(Math.max(0,e)),[s,r]=[za("presets"),this.buttons[Math.max(0,e)]];return s.scrollLeft+=r.getBoundingClientRect().left-.5*(s.clientWidth-r.offsetWidth),t&&e<0&&this.tell(`The playground has no motion called ${t}; it has ${this.presets.map(({key:o})=>o).join(", ")}.`),n}tell(t){let e=document.createElement("li");e.textContent=t,za("story").prepend(e)}choose(t){return this.buttons.forEach((e,n)=>e.setAttribute("aria-pressed",String(n===t))),za("story").replaceChildren(...this.presets[t].story.map(e=>this.sentence(e))),this.presets[t]}sentence(t){let e=document.createElement("li"),[,n,s,r]=/^(.*?)\[(.+?)\](.*)$/s.exec(t.say)??[null,`${t.say} `,t.set&&(t.label??"Show it"),""];if(e.append(n),!s)return e;let o=document.createElement("button");return Object.assign(o,{type:"button",textContent:s}),o.addEventListener("click",()=>this.act(t)),o.addEventListener("pointerup",()=>o.blur()),e.append(o,r),e}};var g2={momentum_norm:"|L|",momentum_space:"L in space","|L|\xB2":"|L|\xB2"},Vh=class{constructor(t,e,n){this.list=t,this.take(e,n)}take(t,e,n=!1){this.data=e,this.rows={},this.list.replaceChildren();for(let[a,c]of[...t.energies?[["energy",e.energyName]]:[],...t.momenta?[["momentum","|L|"]]:[],...t.velocities?[["velocity","|\u03A9|"]]:[]])this.rows[a]=this.row(c);let s=Object.entries(e.drift);if(!s.length||n)return;let r=s.reduce((a,c)=>c[1]>a[1]?c:a),o=(g2[r[0]]??r[0]).replaceAll("_"," ");this.row("largest drift").textContent=`${zt(r[1],2)} (${o})`}row(t){let[e,n]=[document.createElement("dt"),document.createElement("dd")];e.textContent=t;let s=document.createElement("div");return s.append(e,n),this.list.append(s),n}show(t){let e=(r,o)=>{this.rows[r]&&this.rows[r].textContent!==o&&(this.rows[r].textContent=o)},{energy:n=[1,this.data.energyUnit],momentum:s=[1,"kg m\xB2/s"]}=this.data.units??{};t.energy!==null&&e("energy",`${zt(t.energy/n[0])} ${n[1]}`),t.momentum&&e("momentum",`${zt(t.momentum.length()/s[0])} ${s[1]}`),t.velocity&&e("velocity",`${zt(t.velocity.length(),5)} rad/s`)}};var x2=[["video/webm;codecs=vp9","webm"],["video/webm;codecs=vp8","webm"],["video/webm","webm"],["video/mp4","mp4"]];var bx=()=>typeof MediaRecorder<"u"&&typeof HTMLCanvasElement.prototype.captureStream=="function"&&!!wx(),wx=()=>x2.find(([i])=>MediaRecorder.isTypeSupported(i)),Hh=class{constructor(t,e,n){let[s,r]=wx();this.canvas=t,this.begun=performance.now();let o=[],a=t.captureStream(30);this.recorder=new MediaRecorder(a,{mimeType:s,videoBitsPerSecond:8e6}),this.recorder.addEventListener("dataavailable",({data:c})=>c.size&&o.push(c)),this.recorder.addEventListener("stop",()=>{for(let c of a.getTracks())c.stop();n(o.length?new Blob(o,{type:s}):null,r)}),this.recorder.start(),this.waiting=setTimeout(()=>this.close(),1e3*e)}get passed(){return(performance.now()-this.begun)/1e3}paint(t){this.draw=t,t(this.canvas)}close(){this.draw?.(this.canvas),this.waiting=setTimeout(()=>this.stop(),3e3/30)}stop(){clearTimeout(this.waiting),this.recorder.state!=="inactive"&&this.recorder.stop()}};var _2=760,[_f,y2,yf]=[.5,10,60],zn=i=>document.getElementById(i),Wh=class{constructor(t){this.page=t;let e=(n,s)=>zn(n).addEventListener("click",s);e("link",()=>this.copyLink()),e("embed",()=>this.copyEmbedCode()),e("spec",()=>this.copySpec()),e("picture",()=>this.savePicture()),e("film",()=>this.film?this.film.stop():this.saveFilm()),zn("film-length").addEventListener("change",()=>this.check())}take(){zn("spec").hidden=!this.page.instrument?.kind.toml;for(let t of["copied","saved"])zn(t).hidden=!0;this.say(""),this.given=null,this.suggest()}say(t){zn("shared").textContent=t}async copy(t,e){let n=zn("copied");n.value=t,n.hidden=!1;try{await navigator.clipboard.writeText(t),this.say(e)}catch{this.say("This browser keeps the clipboard from pages in frames: copy the text from the field below."),n.select()}}copyLink(){let{whole:t,fragment:e}=this.page.address;if(t===null)return this.copy(`#${e}`,"A page in a notebook has no address of its own. Write it to a file with write_page, and add this to the file's address.");let n=t.startsWith("file:")?" It opens on this computer only: put the file on a web server to give it to others.":"";return this.copy(t,`The link is copied.${n}`)}copyEmbedCode(){let{whole:t}=this.page.address;if(t===null)return this.say("A page in a notebook has no address that another page could embed. Write it to a file with write_page, and put the file on a web server.");let e=`polhode: ${zn("name").textContent}`,[n,s]=[t,e].map(o=>o.replaceAll("&","&amp;").replaceAll('"',"&quot;").replaceAll("<","&lt;")),r=`<iframe src="${n}" title="${s}" loading="lazy" sandbox="allow-scripts allow-downloads" allow="clipboard-write" style="width:100%; height:${_2}px; border:0"></iframe>`;return this.copy(r,"The code is copied: paste it into the HTML of a page.")}copySpec(){let t=this.page.instrument.toml(this.page.motion.span);return t===null?this.say("No spec says this start. A gyrostat needs its rotor's moment, and a free rotor a principal axis; a disk must begin in steady rolling."):this.copy(t,"The spec is copied: paste it into a file, and run polhode report on it.")}savePicture(){let t=this.page.shot();if(Ax()){let e=zn("saved");return e.src=t.toDataURL("image/png"),e.hidden=!1,this.say("A frame like this one may not save files: save the picture below by a right click, or by a long press.")}return t.toBlob(e=>this.save(e,"png"),"image/png"),this.say("The picture is saved.")}saveFilm(){if(!bx())return this.say("This browser cannot record films: it has no MediaRecorder for canvases. Firefox and Chromium have.");let t=this.check();if(t===null)return;let{timebar:e}=this.page,n=e.playing,s=()=>this.say(`Recording: ${Math.min(this.film.passed,t).toFixed(1)} of ${zt(t,3)} s.`),r=setInterval(s,200);return this.film=new Hh(this.page.shot(),t,(o,a)=>{clearInterval(r),this.film=null,zn("film").textContent="Save film",n||e.pause(),o&&this.save(o,a),this.say(o?Ax()?"The film is recorded. If it was not saved, this frame may not save files: open the page on its own.":"The film is saved.":"The browser has recorded nothing.")}),zn("film").textContent="Stop",n||e.toggle(),s()}frame(){this.film?.paint(t=>this.page.shot(t))}suggest(){if(this.given!==null)return;let{instrument:t,motion:e,timebar:n}=this.page,{period:s=null,nutationPeriod:r=null}=e?.solver??{},a=([s,r,t?.event??null].find(l=>l!==null&&Number.isFinite(l)&&l>0)??e?.span??0)/n.rate,c=a>0&&Number.isFinite(a)?Math.min(yf,Math.max(_f,a)):y2;zn("film-length").value=String(Number(c.toFixed(1)))}check(){let t=zn("film-length"),e=Number(t.value.trim().replace(",",".")),n=t.value.trim()!==""&&e>=_f&&e<=yf;return t.setAttribute("aria-invalid",String(!n)),this.say(n?"":`A film takes ${_f} to ${yf} s; got ${t.value.trim()||"nothing"}. Type a number between these.`),this.given=n?e:this.given,n?e:null}save(t,e){let n=document.createElement("a");n.href=URL.createObjectURL(t),n.download=`${zn("name").textContent.replace(/[^\p{L}\p{N}]+/gu,"-").replace(/^-+|-+$/g,"")||"motion"}.${e}`,n.click(),setTimeout(()=>URL.revokeObjectURL(n.href),6e4)}};function Ax(){try{return window.self!==window.top&&!window.localStorage}catch{return!0}}var es={s:["sec","secs","second","seconds"],ms:["msec","millisecond","milliseconds"],us:["usec","\xB5s","\u03BCs","microsecond","microseconds"],ns:["nsec","nanosecond","nanoseconds"],min:["mins","minute","minutes"]},Ex={deg:["\xB0","degs","degree","degrees"],rad:["rads","radian","radians"]},ns={"deg/s":["\xB0/s","deg/sec","degree/s","degrees/s","degrees/sec","dps","deg s-1","deg s^-1","deg_s","deg_per_s","deg_per_sec"],"rad/s":["rad/sec","radian/s","radians/s","radians/sec","rad s-1","rad s^-1","rad_s","rad_per_s","rad_per_sec"],rpm:["rev/min","r/min"]},vf={"deg/s":Math.PI/180,"rad/s":1,rpm:Math.PI/30},v2={"m/s\xB2":1,"m/s^2":1,"m/s2":1,"m/s/s":1,g:9.80665},Tx=/^(.*?)\s*[[(]([^\])]*)[\])]\s*$/;function qh(i,t){let e=i.trim().toLowerCase().split(/\s+/).join(" ");return Object.keys(t).find(n=>n===e||t[n].includes(e))??null}function M2(i){let t=Tx.exec(i);return t?.[1]?t[1]:i.trim()}function ar(i,t){let e=Tx.exec(i);if(e)return qh(e[2],t);let n=i.trim().toLowerCase().split("_");for(let s=Math.min(4,n.length-1);s>0;s--){let r=qh(n.slice(-s).join("_"),t);if(r)return r}return null}var mi=(i,t="xyz")=>[...t].map(e=>i.replace("{}",e)),S2=[{name:"AndroSensor",time:["time since start in ms"],timeUnit:"ms",gyro:mi("gyroscope {}"),rateUnit:"rad/s",acceleration:[mi("accelerometer {}")],perUnit:1},{name:"phyphox",time:["time"],timeUnit:"s",gyro:mi("gyroscope {}"),rateUnit:"rad/s",acceleration:[mi("acceleration {}"),mi("accelerometer {}")],perUnit:1},{name:"Sensor Logger",time:["seconds_elapsed"],timeUnit:"s",gyro:mi("{}"),rateUnit:"rad/s",acceleration:[mi("{}")],perUnit:1},{name:"Sensor Logger, all in one file",time:["seconds_elapsed"],timeUnit:"s",gyro:mi("gyroscope_{}"),rateUnit:"rad/s",acceleration:[mi("totalacceleration_{}")],perUnit:1},{name:"Betaflight",time:["time"],timeUnit:"us",gyro:mi("gyroadc[{}]","012"),rateUnit:"deg/s",acceleration:[mi("accsmooth[{}]","012")],perUnit:null}];function ka(i,t){let e=t.map(n=>i.flatMap((s,r)=>s.trim().toLowerCase()===n||M2(s).trim().toLowerCase()===n?[r]:[]));return e.every(n=>n.length===1)?e.map(([n])=>n):null}function Mf(i,t){for(let e of t.time){let n=ka(i,[e]);if(n)return n[0]}return null}var Rx=i=>S2.find(t=>ka(i,t.gyro)&&Mf(i,t)!==null)??null;function Cx(i,t){let e=i.includes("(")?i.trim().slice(i.trim().lastIndexOf("(")+1).replace(/[) ]+$/,"").toLowerCase():"";return v2[e]??t.perUnit}var de=class extends Error{},Ga=i=>`"${i.length>60?`${i.slice(0,57)}...`:i}"`;var ve=i=>Va(i,.5);function Va(i,t){let e=Float64Array.from(i).sort();if(!e.length)return NaN;let n=t*(e.length-1),s=Math.floor(n),r=Math.min(s+1,e.length-1);return e[s]+(n-s)*(e[r]-e[s])}function Ni(i){let t=Math.floor(i);return i-t!==.5?Math.round(i):t%2===0?t:t+1}var Ve=i=>Float64Array.from({length:Math.max(i.length-1,0)},(t,e)=>i[e+1]-i[e]);function is(i){let t=[];for(let e=0;e<i.length;e++){if(!i[e])continue;let n=e;for(;e<i.length&&i[e];)e+=1;t.push([n,e])}return t}function kn(i,t,e=!1){let[n,s]=[0,i.length];for(;n<s;){let r=n+s>>1;i[r]<t||e&&i[r]===t?n=r+1:s=r}return n}function gi(i){return Float64Array.from({length:i.length/3},(t,e)=>Math.hypot(i[3*e],i[3*e+1],i[3*e+2]))}var cr=(i,t)=>Float64Array.from({length:i.length/3},(e,n)=>i[3*n+t]);function ss(i,t=0,e=i.length/3){let n=[0,0,0];for(let s=t;s<e;s++)for(let r=0;r<3;r++)n[r]+=i[3*s+r];return n.map(s=>s/(e-t))}function Xh(i,t=3){let e=[];for(let n of i)for(let s=0;s+3*t<n.length;s++)e.push(Math.abs(n[s+3*t]-3*n[s+2*t]+3*n[s+t]-n[s]));return e.length?ve(e)/(.6745*Math.sqrt(20)):0}var bf=[";","	",","," "],$h=60,Lx=2e3,Ix=1e6,b2=new Set(["","nan","na","n/a","null","none","-"]),Nx=/^(?:[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[+-]?\d+)?|[+-]?(?:nan|inf|infinity))$/i,w2=/^[+-]?[\d.]+(?:[eE][+-]?\d+)?\s+[+-]?[\d.]+(?:[eE][+-]?\d+)?$/,A2=/^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,6})?$/,Dx=/^[+-]?\d*,\d+(?:[eE][+-]?\d+)?$/,E2=/"[^"]*"|[^\s[("]+(?:[ \t]*(?:\[[^\]]*\]|\([^)]*\)))?/g;function Ux(i){let t=i.replace(/^\uFEFF/,"").split(/\r\n|\n|\r/);return t.at(-1)===""&&t.pop(),t.map((e,n)=>{if(e.includes("\0")||e.includes("\uFFFD"))throw new de(`line ${n+1} is not UTF-8 text, so this is not a table. Choose the app's CSV file, unpacked from its archive.`);if(e.length>Ix)throw new de(`line ${n+1} has more than ${Ix} characters. Choose a table with one sample in each line.`);return{number:n+1,text:e}})}var Yh=i=>/^\s*(?:[#%]|$)/.test(i);function go(i,t){if(!i.includes('"')){let r=i.trim();return t===" "?r?r.split(/\s+/):[]:i.split(t).map(o=>o.trim())}let e=t===" "?i.trim().split(/\s+/).join(" "):i,n=[],s=0;for(;;){for(;e[s]===" "&&t!==" ";)s+=1;let r="";if(e[s]==='"'){for(s+=1;e[s]!=='"'||e[s+1]==='"';s++){if(s>=e.length)return null;e[s]==='"'&&(s+=1),r+=e[s]}if(s+=1,s<e.length&&e[s]!==t)return null}else{let o=e.indexOf(t,s);r=o<0?e.slice(s):e.slice(s,o),s=o<0?e.length:o}if(n.push(r.trim()),s>=e.length)return n;s+=1}}function wf(i){let t=i.slice(0,Lx+$h),e=t.filter(({text:d})=>!Yh(d)).slice(0,$h),s=bf.map(d=>({delimiter:d,...T2(e,d)})).reduce((d,f)=>f.count>d.count?f:d);if(!s.count){let d=e.length?`; its first line is ${Ga(e[0].text)}`:"";throw new de(`it has no line of numbers in two columns or more, between commas, semicolons, tabs or blanks${d}. Choose a table with one sample in each line.`)}let{delimiter:r,begin:o}=s,a=go(e[o].text,r),c=e[o].number,l=d=>({delimiter:r,width:a.length,names:d,first:c}),h=t.filter(({number:d,text:f})=>Yh(f)&&f.trim()&&d<e[0].number).slice(-1);if(o>1){let d=C2(e[o-2].text,e[o-1].text,r,a);if(d.length)return l(d)}let u=o?[e[o-1]]:h;for(let{text:d}of u){let f=Sf(d,r,a);if(f.length)return l(f)}if(o){let{number:d,text:f}=u[0];throw new de(`line ${d} must name the ${a.length} columns that line ${c} has; got ${Fx(f,r).length} names. Name each, or delete the line.`)}return l([])}function T2(i,t){let e=null,n=[];return i.forEach(({text:s},r)=>{let o=go(s,t)??[];e===null&&R2(o)&&(e=r),e!==null&&n.push(o.length)}),e===null?{count:0,begin:0}:{count:n.filter(s=>s===n[0]).length,begin:e}}function R2(i){let t=i.filter(Boolean),e=t.filter(n=>Nx.test(n));return i.length>1&&2*e.length>t.length&&!t.some(n=>w2.test(n))}var Ox=i=>i.trimStart().replace(/^[#%]+/,""),Fx=(i,t)=>go(Ox(i),t)??[];function Sf(i,t,e){let n=Fx(i,t);return t===" "&&n.length!==e.length&&(n=(Ox(i).match(E2)??[]).map(r=>r.replace(/^"+|"+$/g,""))),n.length===e.length-1&&!e.at(-1)&&(n=[...n,""]),n.length===e.length&&n.some(Boolean)&&!n.some(r=>Nx.test(r))?n:[]}var Px=i=>[es,Ex,ns].some(t=>qh(i,t));function C2(i,t,e,n){let s=Sf(i,e,n),r=Sf(t,e,n).map(o=>o.replace(/^[[\]()]+|[[\]()]+$/g,""));return!s.length||!r.some(Px)||s.some(Px)?[]:s.map((o,a)=>r[a]?`${o} [${r[a]}]`:o)}function Bx(i,t){if(t.delimiter===",")return"point";let n=i.slice(0,Lx+$h).filter(({number:s,text:r})=>s>=t.first&&!Yh(r)).slice(0,$h).flatMap(({text:s})=>s.split(t.delimiter).map(r=>r.replace(/^[ "]+|[ "]+$/g,"")));return n.some(s=>Dx.test(s))&&!n.some(s=>s.includes("."))?"comma":"point"}function zx(i,t,e,n){let s=e.map(()=>[]),r=[];for(let{number:o,text:a}of i){if(o<t.first||Yh(a))continue;let c=go(a,t.delimiter);if(!c)throw new de(`line ${o} has quotes that do not close. Check the line.`);for(;c.length>t.width&&!c.at(-1);)c.pop();if(c.length!==t.width){let l=t.delimiter===","?" Is the comma a decimal one? Then save it with semicolons.":"";throw new de(`line ${o} has ${c.length} cells, and line ${t.first} has ${t.width}. Check the line, or delete it.${l}`)}e.forEach((l,h)=>s[h].push(I2(c[l],n,()=>`line ${o}, ${Af(t,l)}`))),r.push(n==="comma"?c[e[0]].replaceAll(",","."):c[e[0]])}return{numbers:s.map(o=>Float64Array.from(o)),texts:r}}function I2(i,t,e){if(b2.has(i.toLowerCase()))return NaN;if(t==="comma"&&i.includes("."))throw new de(`${e()}: ${Ga(i)} has a point, and the other numbers have decimal commas. Choose one of them.`);let n=t==="comma"&&Dx.test(i)?i.replace(",","."):i,s=A2.test(n)?Number(n):NaN;if(Number.isFinite(s)&&!(s===0&&/^[+-]?[0.]*[1-9]/.test(n)))return s;let r=Number.isNaN(s)?"must be a number in decimal digits":s===0?"is so small that nothing is left of it":"is too large for a number",o=n.includes(":")?"Dates and times of day are not read: give times as plain numbers, like seconds from the start.":"Correct it, or leave the cell blank.";throw new de(`${e()}: ${Ga(i)} ${r}. ${o}`)}var Af=(i,t)=>i.names[t]?`column ${t+1} ${Ga(i.names[t])}`:`column ${t+1}`;var kx=8,P2=3,L2=.02,N2=1.1,Gx=1e12,Ef=1e-9,D2=1e-10,U2={s:0,ms:3,us:6,ns:9},O2={s:1,ms:1e3,us:1e6,ns:1e9},qx=40;function Xx(i){let t=Ux(i);for(let e=0;e<Math.min(t.length,2e3);e++)for(let n of bf){let s=Rx(go(t[e].text,n)??[]);if(!s)continue;let r=t.slice(e);if(!r.slice(1).some(o=>/[^ \t;,]/.test(o.text)))throw new de(`no sample stands below the header in line ${t[e].number}. Log again.`);return{form:wf(r),dialect:s,lines:t}}return{form:wf(t),dialect:null,lines:t}}function $x({form:i,dialect:t}){let{names:e}=i;if(t){let[a,c]=[Mf(e,t),ka(e,t.gyro)],l=Vx(c.map(h=>e[h]),ns);return{time:a,timeUnit:ar(e[a],es)??t.timeUnit,gyro:c,rateUnit:ar(e[c[0]],ns)?l:t.rateUnit}}let n=e.flatMap((a,c)=>ar(a,es)?[c]:[]),s=e.flatMap((a,c)=>ar(a,ns)?[c]:[]),r=n.length===1?n[0]:null,o=s.length===3?s:null;return{time:r,timeUnit:r===null?null:ar(e[r],es),gyro:o,rateUnit:o&&Vx(o.map(a=>e[a]),ns)}}function Vx(i,t){let e=new Set(i.map(n=>ar(n,t)).filter(Boolean));return e.size===1?[...e][0]:null}function Yx({form:i,dialect:t,lines:e},n){if(n.time===null||!n.gyro||n.gyro.includes(null))throw new de("it is not known which columns have the time and the angular velocities: no app that is known writes such a header. Choose them.");let s=[n.time,...n.gyro],r=s.find((p,g)=>s.indexOf(p)<g);if(r!==void 0)throw new de(`${Af(i,r)} is chosen twice. Choose another column for each.`);if(!(n.rateUnit in vf))throw new de("the unit of the angular velocity is not known: the file does not say it. Choose deg/s, rad/s or rpm.");if(!(n.timeUnit in es))throw new de("the unit of the time is not known: the file does not say it. Choose it.");let o=[],a=t?F2(i,t,o):null,{numbers:c,texts:l}=zx(e,i,[...s,...a?a.places:[]],Bx(e,i)),h=B2(c[0],l,n.timeUnit),u=Wx("rates",h,Hx(c.slice(1,4),vf[n.rateUnit]));if(u.times.length<kx)throw new de(`a gyro log must have ${kx} finite samples at different times; this one has ${u.times.length}. Log for longer.`);let d=a?Wx("accelerations",h,Hx(c.slice(4,7),a.unit)):null,f=!!d?.times.length;return{times:u.times,rates:u.values,accelerationTimes:f?d.times:null,acceleration:f?d.values:null,dialect:t?.name??null,rateUnit:n.rateUnit,notes:[...o,...u.notes]}}function F2(i,t,e){for(let n of t.acceleration){let s=n.join()===t.gyro.join()?null:ka(i.names,n);if(!s)continue;let r=Cx(i.names[s[0]],t);return r!==null?{places:s,unit:r}:(e.push("Accelerations are left out, as their unit is not known."),null)}return null}function Hx(i,t){let e=new Float64Array(3*i[0].length);return i.forEach((n,s)=>n.forEach((r,o)=>{e[3*o+s]=r*t})),e}function B2(i,t,e){let n=i.map(o=>e==="min"?60*o:o/O2[e]),s=n.reduce((o,a)=>Number.isFinite(a)?Math.max(o,Math.abs(a)):o,0);if(s===0||2**(Math.floor(Math.log2(s))-52)<=D2)return n;let r=null;return n.map((o,a)=>{if(!Number.isFinite(o))return NaN;let c=z2(t[a],U2[e]??0)*(e==="min"?60n:1n);return r??=c,Number(c-r)/10**qx})}function z2(i,t){let[,e,n,s="",r="0"]=/^([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/.exec(i.trim()),o=qx-s.length+Number(r)-t,a=BigInt(n+s||"0"),c=o>=0?a*10n**BigInt(o):a/10n**BigInt(-o);return e==="-"?-c:c}function Wx(i,t,e){let n=Array.from(t.keys()).filter(_=>Number.isFinite(t[_])&&[0,1,2].every(M=>Number.isFinite(e[3*_+M]))),s=[];n.length<t.length&&s.push(`${t.length-n.length} lines without finite values are left out.`);let r=_=>({t:Float64Array.from(_,M=>t[M]),x:Float64Array.from(_.flatMap(M=>[e[3*M],e[3*M+1],e[3*M+2]]))}),{t:o,x:a}=r(n);k2(i,o,a);let c=Ve(o),l=c.filter(_=>_!==0).map(Math.abs),h=l.length?ve(l):Ef;if(h<Ef)throw new de(`times of ${i} must lie ${Ef} s apart or more; got ${h} s. Check which column has the times, and their unit.`);if(c.every(_=>_>0))return{times:o,values:a,notes:s};c.some(_=>_<0)&&s.push("Lines are not in the order of time; they were sorted."),n=n.sort((_,M)=>t[_]-t[M]),{t:o,x:a}=r(n);let u=_=>_===0||o[_]>o[_-1],d=_=>u(_)||[0,1,2].some(M=>a[3*_+M]!==a[3*_-3+M]),f=Array.from(o.keys()),p=f.filter(_=>d(_)&&!u(_)).length,g=p>=Math.max(P2,L2*o.length),m=f.filter(g?d:u);m.length<o.length&&s.push(`${o.length-m.length} samples come at a time that was there already; the first of each is kept.`),g&&s.push(`The clock is rounded: ${p} samples come at a time that was there already, with other values; they are taken at equal steps.`);let x=r(m.map(_=>n[_]));return{times:g?G2(x.t):x.t,values:x.x,notes:s}}function k2(i,t,e){for(let[n,s]of[["times",t],[i,e]]){let r=s.reduce((o,a)=>Math.max(o,Math.abs(a)),0);if(r>Gx)throw new de(`${n} must be at most ${Gx} in SI units; got ${r}. Check which columns they are, and their unit.`)}}function G2(i){let t=Array.from(i.keys()).filter(u=>u===0||i[u]>i[u-1]),e=t.length>1?ve(Ve(t.map(u=>i[u]))):0,n=Float64Array.from(i);t.forEach((u,d)=>{let f=t[d+1]??i.length,p=Math.min(f<i.length?i[f]-i[u]:e,e);for(let g=u;g<f;g++)n[g]=i[u]+(g-u)/(f-u)*p});let s=i.length,r=.5*(s-1),o=i.reduce((u,d)=>u+d,0)/s,a=i.reduce((u,d,f)=>u+(f-r)*(d-o),0)/(s*(s*s-1)/12),c=i.map((u,d)=>u-(o+a*(d-r))),[l,h]=c.reduce(([u,d],f)=>[Math.min(u,f),Math.max(d,f)],[1/0,-1/0]);return h-l<=N2*e?Float64Array.from({length:s},(u,d)=>i[0]+a*d):n}function xo(i){let t=i.length,e=i.map(r=>Float64Array.from(r)),n=i.map((r,o)=>Float64Array.from({length:t},(a,c)=>o===c?1:0));for(let r=0;r<60;r++){let o=!1;for(let a=0;a<t-1;a++)for(let c=a+1;c<t;c++){let l=e[a][c];if(Math.abs(l)<=1e-17*Math.sqrt(Math.abs(e[a][a]*e[c][c]))||Math.abs(l)<1e-300)continue;o=!0;let[h,u]=Jx(e[a][a],l,e[c][c]);for(let d=0;d<t;d++)[e[d][a],e[d][c]]=[h*e[d][a]-u*e[d][c],u*e[d][a]+h*e[d][c]];for(let d=0;d<t;d++)[e[a][d],e[c][d]]=[h*e[a][d]-u*e[c][d],u*e[a][d]+h*e[c][d]];e[a][c]=e[c][a]=0;for(let d=0;d<t;d++)[n[d][a],n[d][c]]=[h*n[d][a]-u*n[d][c],u*n[d][a]+h*n[d][c]]}if(!o)break}let s=e.map((r,o)=>o).sort((r,o)=>e[r][r]-e[o][o]);return{values:s.map(r=>e[r][r]),vectors:s.map(r=>n.map(o=>o[r]))}}function Jx(i,t,e){let n=(e-i)/(2*t),s=(n<0?-1:1)/(Math.abs(n)+Math.hypot(n,1)),r=1/Math.hypot(s,1);return[r,s*r]}function Kx(i){let t=i.length,e=i.map((r,o)=>Float64Array.from({length:t},(a,c)=>o===c?1:0));for(let r=0;r<60;r++){let o=!1;for(let a=0;a<t-1;a++)for(let c=a+1;c<t;c++){let[l,h]=[i[a],i[c]],[u,d,f]=[xi(l,l),xi(l,h),xi(h,h)];if(Math.abs(d)<=1e-16*Math.sqrt(u*f)||d===0)continue;o=!0;let[p,g]=Jx(u,d,f);Zx(l,h,p,g),Zx(e[a],e[c],p,g)}if(!o)break}let n=i.map(r=>Math.sqrt(xi(r,r))),s=n.map((r,o)=>o).sort((r,o)=>n[o]-n[r]);return{values:s.map(r=>n[r]),vectors:s.map(r=>Array.from(e[r]))}}function Zx(i,t,e,n){for(let s=0;s<i.length;s++){let[r,o]=[i[s],t[s]];i[s]=e*r-n*o,t[s]=n*r+e*o}}function xi(i,t){let e=0;for(let n=0;n<i.length;n++)e+=i[n]*t[n];return e}function Zh(i,t){let e=t.length,n=i.map((r,o)=>[...r,t[o]]);for(let r=0;r<e;r++){let o=r;for(let a=r+1;a<e;a++)Math.abs(n[a][r])>Math.abs(n[o][r])&&(o=a);if([n[r],n[o]]=[n[o],n[r]],n[r][r]===0||!Number.isFinite(n[r][r]))return null;for(let a=r+1;a<e;a++){let c=n[a][r]/n[r][r];for(let l=r;l<=e;l++)n[a][l]-=c*n[r][l]}}let s=new Array(e);for(let r=e-1;r>=0;r--){let o=n[r][e];for(let a=r+1;a<e;a++)o-=n[r][a]*s[a];s[r]=o/n[r][r]}return s}var Vs=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]],Jh=([i,t,e])=>xi(i,Vs(t,e));var jx=Math.SQRT2,Qx=[[0,1],[0,2],[1,2]],V2=.02,H2=.5,W2=2,[q2,X2]=[75,.6],$2=5,Y2=Math.PI/180,Z2=([i,t,e,n],[s,r,o,a])=>[i*s-t*r-e*o-n*a,i*r+t*s+e*a-n*o,i*o-t*a+e*s+n*r,i*a+t*o-e*r+n*s];function Tf(i){let t=Math.hypot(...i),e=t<.001?.5-t*t/48:Math.sin(.5*t)/t;return[Math.cos(.5*t),...i.map(n=>e*n)]}function Rf([i,t,e,n]){return[[1-2*(e*e+n*n),2*(t*e-i*n),2*(t*n+i*e)],[2*(t*e+i*n),1-2*(t*t+n*n),2*(e*n-i*t)],[2*(t*n-i*e),2*(e*n+i*t),1-2*(t*t+e*e)]]}function Ha(i,t){let e=[[1,0,0,0]];for(let n=1;n<i.length;n++){let s=i[n]-i[n-1],[r,o]=[He(t,n-1),He(t,n)],a=Vs(r,o),c=Z2(e[n-1],Tf(r.map((h,u)=>.5*s*(h+o[u])+s*s/12*a[u]))),l=Math.hypot(...c);e.push(c.map(h=>h/l))}return e}var He=(i,t)=>[i[3*t],i[3*t+1],i[3*t+2]];function Wa(i,t){let e=i.length,n=new Float64Array(18*e);for(let s=0;s<e;s++){let r=Rf(i[s]),o=He(t,s);for(let a=0;a<3;a++){let c=18*s+6*a;for(let l=0;l<3;l++)n[c+l]=r[a][l]*o[l];Qx.forEach(([l,h],u)=>{n[c+3+u]=(r[a][l]*o[h]+r[a][h]*o[l])/jx})}}return n}function Cf(i){let t=[0,1,2].map(e=>[0,1,2].map(n=>e===n?i[e]:0));return Qx.forEach(([e,n],s)=>{t[e][n]=t[n][e]=i[3+s]/jx}),t}function J2(i){let t=i.reduce((f,p)=>f+p.elapsed.length,0),e=Array.from({length:6},()=>new Float64Array(3*t)),n=0;for(let{elapsed:f,rates:p}of i){let g=f.length,m=Wa(Ha(f,p),p),x=Kh(m,0,g);for(let _=0;_<g;_++)for(let M=0;M<3;M++,n++)for(let v=0;v<6;v++)e[v][n]=m[18*_+6*M+v]-x[6*M+v]}let{values:s,vectors:r}=Kx(e),o=Cf(r[5]),a=Math.sign(o[0][0]+o[1][1]+o[2][2])||1,c=xo(o.map(f=>f.map(p=>a*p))),[l,h]=c.vectors,u=[l,h,Vs(l,h)],d=[0,1,2].map(f=>u.map(p=>p[f]));return{moments:K2(c.values),axes:d,singularValues:s}}function Kh(i,t,e){let n=new Float64Array(18);for(let s=t;s<e;s++)for(let r=0;r<18;r++)n[r]+=i[18*s+r];return n.map(s=>s/(e-t))}function K2(i){let t=.5*(i[0]+i[1]+i[2]),e=Math.max(t-i[0],1e-300),n=Math.max(t-i[1],.02*e),s=Math.max(t-i[2],V2*e),r=[n+s,e+s,e+n].sort((o,a)=>o-a);return r.map(o=>o/r[2])}function t_(i){let t=J2(i),e=Xh(i.map(({rates:h})=>h)),n=i.reduce((h,{elapsed:u})=>h+u.length,0),s=6*e*Math.sqrt(n),r=i.map(({elapsed:h,rates:u})=>{let d=gi(u);return Ve(h).map((f,p)=>f*d[p+1])}),o=Math.max(...r.map(h=>h.reduce((u,d)=>u+d,0))),a=Math.max(...r.map(ve)),c=Math.max(...i.map(({rates:h})=>ve(gi(h)))),l=null;return a>W2?l=`The rates say that the body turns by ${a.toPrecision(3)} rad from sample to sample, too far to be followed: the rates are of another unit, like deg/s, or the times are.`:c>q2&&t.moments[0]>X2?l=`The rates, about ${c.toPrecision(3)} rad/s, are beyond what gyros can tell, and make the body nearly a sphere. Both happen where rates in deg/s are read as rad/s: choose their unit.`:o<H2?l=`The body turned by ${o.toPrecision(2)} rad only: nothing can be said of its inertia.`:t.singularValues[4]<s&&(l=j2(i)),{...t,noise:e,degenerate:l}}function j2(i){let t=i.map(({rates:o})=>{let a=gi(o),c=a.length,l=[0,1,2].map(d=>a.reduce((f,p,g)=>f+o[3*g+d],0)/c),h=Math.hypot(...l);return{away:Math.max(...a.map((d,f)=>{let p=xi(He(o,f),l)/Math.max(d*h,1e-300);return Math.acos(Math.min(1,Math.max(-1,p)))/Y2})),speed:a.reduce((d,f)=>d+f,0)/c,toward:l.map(d=>d/Math.max(h,1e-300))}}),{away:e,speed:n,toward:s}=t.reduce((o,a)=>a.away>o.away?a:o),r=`(${s.map(o=>o.toFixed(2)).join(", ")})`;return e<$2?`The rates (${n.toPrecision(3)} rad/s) stay within ${e.toPrecision(2)}\xB0 of one direction of the device, ${r}: the body spins about a principal axis, or is a sphere; either way the log does not determine the moments. Throw it with a tumble, best about its middle axis.`:`Within the noise, bodies of quite different moments fit the rates (${n.toPrecision(3)} rad/s, up to ${e.toFixed(0)}\xB0 from ${r}). Throw it longer or faster, with a tumble about its middle axis.`}var e_=600;function n_(i,t,e,n=0){let{throws:s,windows:r}=i,[o,a]=[tC(i.fit,s[n]),s[n]],{moments:c}=o,l=i_(o,a),[h,u]=ss(l),d=o.starts[n].map((_,M)=>_*c[M]),[f,p]=[a.times[0],a.times.at(-1)],g=Float64Array.from({length:e_},(_,M)=>f+(p-f)*M/(e_-1)),m=`I1/I3 = ${c[0].toFixed(3)}, I2/I3 = ${c[1].toFixed(3)}`,x={type:"body",traced:1,shape:"box or ellipsoid of the same inertia",surface:null,ellipsoid:null,changed:!0,azimuth:Math.atan2(u,h)};return{name:e,key:null,summary:`Free flight from ${f.toPrecision(4)} s to ${p.toPrecision(4)} s of the log, and the exact motion of the fitted body: ${m}.`,notes:["A gyro tells the moments up to a common factor: on this page the largest is 1 kg m\xB2.",...t.notes],panels:[x,{type:"sphere",title:"Momentum sphere",legend:"other polhodes",words:"L in body axes runs along its polhode; dots are the log's samples",measured:l},{type:"poinsot"}],drift:{},scatters:[],plots:[],times:eC(g),joined:!0,space:null,up:"L",free:c,energyName:"energy",energyUnit:"J",model:{solver:"FreeMotion",moments:c,momentum:d,attitude:[1,0,0,0],epoch:a.epoch},story:Q2(i,t,r[n],m)}}function Q2({throws:i,windows:t,limit:e,start:n,rest:s,fit:r,misfit:o},a,c,l){let h=a.dialect?`Read as a log of ${a.dialect}, rates in ${a.rateUnit}.`:`Rates are read in ${a.rateUnit}, as chosen.`,u=r.bias.map(f=>f.toFixed(3).replace("-","\u2212")).join(", "),d=`${t.length>1?`${t.length} free flights are found; this one`:"One free flight is found; it"} lasts ${(c.end-c.start).toPrecision(2)} s: ${c.reason}.`;return[`${h} ${d}`,`${l}; the gyro's bias is ${u} rad/s, ${s?"which a rest confirms":"and no rest in the log confirms it"}.`,...r.drag?[`Drag slows it: c/I3 = ${r.drag.map(f=>f.toFixed(4).replace("-","\u2212")).join(", ")} of the torque \u2212c |\u03C9| \u03C9 along the axes. The curves are of the free motion that touches it in the middle of the flight.`]:[],o??`The residuals, ${r.rms.toPrecision(2)} rad/s rms, are those of the noise, ${n.noise.toPrecision(2)} rad/s: within it the log is the motion of a ${r.drag?"rigid body with drag":"free rigid body"}.`,...e===null?[]:[`Samples at the gyro's limit, ${(e*180/Math.PI).toPrecision(4)} deg/s, are left out; ${i.reduce((f,{times:p})=>f+p.length,0)} remain.`]]}function tC(i,t){let e=ss(i_(i,t)),n=[e[0]<0?-1:1,1,e[2]<0?-1:1];n[1]=n[0]*n[2];let s=r=>r.map((o,a)=>n[a]*o);return{...i,axes:i.axes.map(s),starts:i.starts.map(s)}}function i_({moments:i,axes:t,bias:e},{rates:n,times:s}){return Array.from(s,(r,o)=>{let a=He(n,o).map((h,u)=>h-e[u]),c=i.map((h,u)=>h*(t[0][u]*a[0]+t[1][u]*a[1]+t[2][u]*a[2])),l=Math.hypot(...c)||1;return c.map(h=>h/l)}).flat()}function eC(i){let t="";for(let e of new Uint8Array(i.buffer))t+=String.fromCharCode(e);return{kind:"f8",shape:[i.length],data:btoa(t)}}var nC=[.3,.6,1.2,2.4],iC=2,sC=1,Qh=.03,jh=[.3,1],rC=3,oC=.07,aC=4,If=12,s_=6,r_=2e4,cC=.1;function o_(i,t,e){let n=[];for(let[s,r]of uC(i,gi(t)))for(let o=s;o<=r;o+=r_/2){let a=Math.min(o+r_,r+1);if(i[a-1]-i[o]>=e&&n.push(...dC(i.slice(o,a),t.slice(3*o,3*a),e,o)),a>r)break}return yC(n)}function a_(i,t){let e=Wa(Ha(i,t),t),n=Math.floor(i.length/4),[s,r]=[n,i.length-n],o=g_(i,e,s,r,f_(e,s,r).inertia);return!o||o.first>s||o.last<r-1?null:{...o,change:m_(e,o.first,o.last+1,o.inertia)}}function c_(i,t,e){let n=e.map(({first:c,last:l,change:h})=>{let u=t.slice(3*c,3*l+3),d=Wa(Ha(i.slice(c,l+1),u),u);return{...l_(d,0,l+1-c),change:h}}),s=e.map((c,l)=>l).sort((c,l)=>e[l].turn-e[c].turn),r=[];for(let c of s){let l=r.find(h=>lC([...h,c].map(u=>n[u])));l?l.push(c):r.push([c])}let[o,a]=[[],-1/0];for(let c of r){let l=c.reduce((h,u)=>h+e[u].turn,0);l>a&&([o,a]=[c,l])}return[e.filter((c,l)=>o.includes(l)),e.filter((c,l)=>!o.includes(l))]}function l_(i,t,e){let n=Kh(i,t,e),s=new Float64Array(36);for(let r=t;r<e;r++)h_(s,i,r);return{mean:n,spread:u_(n,s.map(r=>r/(e-t)))}}function h_(i,t,e){for(let n=0;n<3;n++){let s=18*e+6*n;for(let r=0;r<6;r++)for(let o=0;o<6;o++)i[6*r+o]+=t[s+r]*t[s+o]}}function u_(i,t){return[0,1,2,3,4,5].map(e=>[0,1,2,3,4,5].map(n=>t[6*e+n]-i[e]*i[n]-i[6+e]*i[6+n]-i[12+e]*i[12+n]))}var _o=(i,t,e)=>{let n=0;for(let s=0;s<6;s++)n+=i[t+s]*e[s];return n},d_=(i,t)=>Math.hypot(_o(i,0,t),_o(i,6,t),_o(i,12,t));function lC(i){let t=i.map(({spread:s})=>Math.max(s.reduce((r,o,a)=>r+o[a],0),1e-300)),e=i[0].spread.map((s,r)=>s.map((o,a)=>i.reduce((c,l,h)=>c+l.spread[r][a]/t[h],0))),n=xo(e).vectors[0];return i.every(({mean:s,spread:r,change:o})=>{let a=r.reduce((c,l,h)=>c+n[h]*l.reduce((u,d,f)=>u+d*n[f],0),0);return Math.sqrt(Math.max(a,0))/Math.max(d_(s,n),1e-12)<Math.max(Qh,3*o)})}var f_=(i,t,e)=>p_(l_(i,t,e));function p_({mean:i,spread:t}){let{values:e,vectors:n}=xo(t),s=null;for(let r=0;r<If;r++){let[o,a]=[Math.cos(Math.PI/If*r),Math.sin(Math.PI/If*r)],c=n[0].map((d,f)=>o*d+a*n[1][f]),l=o*o*e[0]+a*a*e[1],h=hC(c),u=h?Math.sqrt(Math.max(l,0))/Math.max(d_(i,c),1e-12):1/0;if((!s||u<s.change)&&(s={inertia:c,change:u}),r===0&&h)break}return s}function hC(i){let t=Cf(i),e=Math.sign(t[0][0]+t[1][1]+t[2][2]),{values:n}=xo(t.map(s=>s.map(r=>e*r)));return n[0]>.03*n[2]&&n[0]+n[1]>.8*n[2]}function m_(i,t,e,n){let s=Kh(i,t,e),r=[0,6,12].map(a=>_o(s,a,n)),o=0;for(let a=t;a<e;a++)for(let c=0;c<3;c++)o+=(_o(i,18*a+6*c,n)-r[c])**2;return Math.sqrt(o/(e-t))/Math.max(Math.hypot(...r),1e-12)}function uC(i,t){let e=i.length,n=Array.from(t,l=>l>sC),s=n.map((l,h)=>n.slice(Math.max(h-2,0),h+3).some(Boolean)),r=n.map((l,h)=>l||h>=2&&h+2<e&&s.slice(h-2,h+3).every(Boolean)),o=Ve(i),a=Math.max(cC,5*ve(o)),c=[];for(let l=0;l<e;l++)r[l]&&(l>0&&r[l-1]&&o[l-1]<a?c.at(-1)[1]=l:c.push([l,l]));return c}function dC(i,t,e,n){let s=Wa(Ha(i,t),t),r=gi(t),o=new Float64Array(i.length);for(let l=1;l<i.length;l++)o[l]=o[l-1]+.5*(r[l]+r[l-1])*(i[l]-i[l-1]);let a=new Uint8Array(i.length),c=[];for(let{begin:l,end:h,inertia:u}of fC(i,s,o)){let d=0;for(let m=l;m<h;m++)d+=a[m];if(d/(h-l)>.5)continue;let f=g_(i,s,l,h,u);if(!f||i[f.last]-i[f.first]<e)continue;let{first:p,last:g}=f;a.fill(1,p,g+1),c.push({first:p+n,last:g+n,change:m_(s,p,g+1,f.inertia),turn:o[g]-o[p]})}return c}function fC(i,t,e){let n=[],s=i.length,r=ve(Ve(i)),o=pC(t);for(let a of new Set(nC.map(c=>Math.max(6,Ni(c/r))))){let c=a>s&&!n.length&&s>=6?s:a,l=[];for(let u=0;u<=s-c;u+=Math.max(1,Math.floor(c/s_)))e[u+c-1]-e[u]>=iC&&l.push(u);let h=l.map(u=>p_(mC(o,u,c)));for(let u of gC(l.length,Math.max(1,Math.floor(l.length/s_)))){let d=u[0];for(let f of u)h[f].change<h[d].change&&(d=f);d!==void 0&&h[d].change<Qh&&n.push({begin:l[d],end:l[d]+c,...h[d]})}}return n.sort((a,c)=>a.change-c.change)}function pC(i){let t=i.length/18,[e,n]=[new Float64Array(18*(t+1)),new Float64Array(36*(t+1))];for(let s=0;s<t;s++){for(let o=0;o<18;o++)e[18*(s+1)+o]=e[18*s+o]+i[18*s+o];let r=new Float64Array(36);h_(r,i,s);for(let o=0;o<36;o++)n[36*(s+1)+o]=n[36*s+o]+r[o]}return{total:e,squares:n}}function mC({total:i,squares:t},e,n){let s=e+n,r=Float64Array.from({length:18},(a,c)=>(i[18*s+c]-i[18*e+c])/n),o=Float64Array.from({length:36},(a,c)=>(t[36*s+c]-t[36*e+c])/n);return{mean:r,spread:u_(r,o)}}function gC(i,t){let[e,n]=[Math.floor(i/t),i%t],s=0;return Array.from({length:t},(r,o)=>Array.from({length:e+(o<n?1:0)},()=>s++))}function g_(i,t,e,n,s){let[r,o]=[e,n-1],a=s;for(let c=0;c<aC;c++){let l=Float64Array.from({length:3*i.length},(g,m)=>_o(t,6*m,a)),h=_C(i,l,r,o),u=xC(is(h.slice(r,o+1)));if(!u)return null;let[d,f]=[r+u[0],r+u[1]-1];for(;d>0&&h[d-1];)d-=1;for(;f<i.length-1&&h[f+1];)f+=1;if(f-d<6)return null;let p=f_(t,d,f+1);if(a=p.inertia,!Number.isFinite(p.change))return null;if(d===r&&f===o)break;[r,o]=[d,f]}return{first:r,last:o,inertia:a}}function xC(i){let t=null;for(let e of i)(!t||e[1]-e[0]>t[1]-t[0])&&(t=e);return t}function _C(i,t,e,n){let s=i.length,r=gi(t).map(g=>Math.max(g,1e-12)),o=(g,m)=>Math.hypot(t[3*m]-t[3*g],t[3*m+1]-t[3*g+1],t[3*m+2]-t[3*g+2]),a=ve(Float64Array.from({length:n-e},(g,m)=>o(e+m,e+m+1)/r[e+m])),c=ve(Ve(i)),l=Math.min(Math.max(1,Ni(oC/c)),Math.max(1,Math.ceil(4*a/(jh[0]*c)))),h=Float64Array.from({length:Math.max(s-l,0)},(g,m)=>o(m,m+l)/(i[m+l]-i[m])/Math.min(r[m+l],r[m])),u=ve(h.slice(e,Math.max(n-l+1,e+1))),d=Math.min(Math.max(jh[0],rC*u),jh[1]),f=Array.from(h,g=>g<d);for(let[g,m]of is(f.map(x=>!x))){let x=Math.min(m+l-1,s-1);x-g<=2*l+2&&o(g,x)/r[g]<jh[0]*(i[x]-i[g])+2*a&&f.fill(!0,g,m)}let p=new Array(s).fill(!1);return f.forEach((g,m)=>{g&&p.fill(!0,m,m+l+1)}),p}function yC(i){let t=[];for(let e of[...i].sort((n,s)=>n.first-n.last-(s.first-s.last)))t.every(n=>e.last<n.first||e.first>n.last)&&t.push(e);return t.sort((e,n)=>e.first-n.first)}var eu=.3,tu=.1,vC=.015,MC=.35,SC=.6,bC=1,wC=.03,x_=[8.8,10.8],AC=.3;function Pf({times:i,rates:t,accelerationTimes:e,acceleration:n}){let{means:s,size:r}=M_(i,t),o=vC+.5*TC(t),a=S_(s,r,o),c=Ve(i);if(i.forEach((d,f)=>{((c[f-1]??0)>=eu||(c[f]??0)>=eu)&&(a[f]=!1)}),n){let d=RC(e,n,i);a.forEach((f,p)=>{a[p]=f&&d[p]})}let l=gi(s).map(d=>d<MC),h=__(y_(a.map((d,f)=>d&&!!l[f]),i),i,t);if(h.length)return h;let u=d=>[0,1,2].every(f=>Math.abs(s[3*d+f])<SC);return h=__(y_(a.map((d,f)=>d&&u(f)),i),i,t),n||EC(h,t)?h:[]}function v_(i){let t=Pf(i),e=[0,0,0],n=0;for(let[s,r]of t){let o=ss(i.rates,s,r+1),a=r+1-s;for(let c=0;c<3;c++)e[c]+=o[c]*a;n+=a}return n?e.map(s=>s/n):e}function __(i,t,e){if(!i.length)return[];let n=i.map(([r,o])=>ss(e,r,o+1)),s=0;return i.forEach(([r,o],a)=>{t[o]-t[r]>t[i[s][1]]-t[i[s][0]]&&(s=a)}),i.filter((r,o)=>Math.hypot(...n[o].map((a,c)=>a-n[s][c]))<wC)}function EC(i,t){if(i.length<2)return!1;let e=ss(t,i[0][0],i[0][1]+1);return i.slice(1).some(([n],s)=>{for(let r=i[s][1];r<n;r++)if(Math.hypot(...e.map((o,a)=>t[3*r+a]-o))>bC)return!0;return!1})}function M_(i,t){let e=ve(Ve(i)),n=Math.max(1,Ni(tu/e)),s=i.length,r=Math.floor(n/2),o=new Float64Array(t.length);for(let a=0;a<3;a++)for(let c=0;c<s;c++){let l=0;for(let h=c-r;h<c-r+n;h++)l+=t[3*Math.min(Math.max(h,0),s-1)+a];o[3*c+a]=l/n}return{means:o,size:Math.max(2,Ni(eu/e))}}function TC(i){let t=[...new Set(Array.from(i.slice(0,6e4),e=>Ni(e*1e9)/1e9))].sort((e,n)=>e-n);return t.length>1?ve(Ve(t)):0}function S_(i,t,e){let n=i.length/3,s=Math.floor(t/2),r=new Array(n).fill(!0);for(let a=0;a<3;a++){let c=cr(i,a);for(let l=0;l<n;l++){if(!r[l])continue;if(l<s||l>=n-Math.floor((t-1)/2)){r[l]=!1;continue}let[h,u]=[1/0,-1/0];for(let d=l-s;d<l-s+t;d++)h=Math.min(h,c[d]),u=Math.max(u,c[d]);r[l]=u-h<e}}let o=new Array(n).fill(!1);for(let a=0;a<n;a++)if(r[a])for(let c=a-s;c<a-s+t;c++)o[c]=!0;return o}function RC(i,t,e){if(i.length<2)return Array.from(e,()=>!1);let{means:n,size:s}=M_(i,t),r=gi(n),o=S_(n,s,AC).map((a,c)=>a&&r[c]>x_[0]&&r[c]<x_[1]);return Array.from(e,a=>{if(a<i[0]||a>i.at(-1))return!1;let c=Math.min(Math.max(kn(i,a,!0)-1,0),i.length-2),l=(a-i[c])/(i[c+1]-i[c]);return(1-l)*Number(o[c])+l*Number(o[c+1])>.5})}function y_(i,t){let e=[];for(let[n,s]of is(i)){let r=n===0?0:kn(t,t[n]+tu/2),o=s===t.length?s-1:kn(t,t[s-1]-tu/2,!0)-1;o>r&&t[o]-t[r]>=eu-tu&&e.push([r,o])}return e}var b_=.3,CC=.05,IC=.35,w_=3,[PC,LC]=[1,4],NC=.02;function A_(i,t){let[e,n]=[i.accelerationTimes,i.acceleration],s=e.length>1?ve(Ve(e)):b_,r=Math.max(3,Ni(b_/s));if(e.length<r)return[];let o=UC(i),a=BC(i,o,r);if(!a)return[];let c=Float64Array.from(e,(u,d)=>Math.hypot(...o[d].map((f,p)=>n[3*d+p]-f[0]*a[0]-f[1]*a[1]-f[2]*a[2]))),l=Array.from(e,(u,d)=>c[d]<w_&&u>=i.times[0]&&u<=i.times.at(-1)),h=[];for(let[u,d]of DC(is(l),Math.max(2,Ni(NC/s)))){let f=Math.max(PC,LC*ve(c.slice(u,d))),[p,g]=[u,d-1];for(;c[p]>=f;)p+=1;for(;c[g]>=f;)g-=1;e[g]-e[p]>=t&&h.push({first:p,last:g})}return h}function DC(i,t){let e=[];for(let[n,s]of i)e.length&&n-e.at(-1)[1]<=t?e.at(-1)[1]=s:e.push([n,s]);return e}function UC(i){let t=OC(i.times,i.rates);return Array.from(i.accelerationTimes,e=>{let[n,s]=[i.rates,t].map(o=>FC(i.times,o,e)),r=[[1,0,0],[0,1,0],[0,0,1]].map(o=>{let[a,c]=[Vs(n,Vs(n,o)),Vs(s,o)];return a.map((l,h)=>l+c[h])});return[0,1,2].map(o=>r.map(a=>a[o]))})}function OC(i,t){let e=new Float64Array(t.length),n=i.length-1;for(let s=0;s<=n;s++)for(let r=0;r<3;r++){let o=l=>t[3*l+r];if(s===0||s===n){let l=s===0?0:n-1;e[3*s+r]=(o(l+1)-o(l))/(i[l+1]-i[l]);continue}let[a,c]=[i[s]-i[s-1],i[s+1]-i[s]];e[3*s+r]=(a*a*o(s+1)+(c*c-a*a)*o(s)-c*c*o(s-1))/(a*c*(a+c))}return e}function FC(i,t,e){if(e<=i[0])return He(t,0);if(e>=i.at(-1))return He(t,i.length-1);let n=kn(i,e,!0)-1,s=(e-i[n])/(i[n+1]-i[n]),r=He(t,n+1);return He(t,n).map((o,a)=>o+s*(r[a]-o))}function BC(i,t,e){let[n,s]=[i.accelerationTimes,i.acceleration],r=[];for(let c=0;c+e<=n.length;c+=Math.max(1,Math.floor(e/8))){if(n[c]<i.times[0]||n[c+e-1]>i.times.at(-1))continue;let l=[0,1,2].map(p=>[0,1,2].map(g=>p===g?.001/CC**2:0)),h=[0,0,0],u=0;for(let p=c;p<c+e;p++){let g=He(s,p);for(let m=0;m<3;m++){u+=g[m]*g[m]/e;for(let x=0;x<3;x++){h[x]+=t[p][m][x]*g[m]/e;for(let _=0;_<3;_++)l[x][_]+=t[p][m][x]*t[p][m][_]/e}}}let d=Zh(l,h),f=d&&u-d.reduce((p,g,m)=>p+g*h[m],0);d&&f<w_**2&&Math.hypot(...d)<IC&&r.push({tells:Jh(l),left:f,at:d})}if(!r.length)return null;let o=Math.max(...r.map(({tells:c})=>c));return r.filter(({tells:c})=>c>=.1*o).reduce((c,l)=>l.left<c.left?l:c).at}var Lf=8,Nf=.25,T_=.15,[zC,kC]=[.004,.1],E_=.1,Df=1-1e-6;function R_(i,t=null){let e=v_(i),{t:n,rates:s}=GC(i.times,i.rates.map((a,c)=>a-e[c%3])),r=i.acceleration?HC(i,n,s):VC(n,s),o=Array.from(i.times).filter((a,c)=>t===null||[0,1,2].every(l=>Math.abs(i.rates[3*c+l])<t*Df));return r.filter(({start:a,end:c})=>kn(o,c,!0)-kn(o,a)>=Lf)}function GC(i,t){let e=ve(Ve(i)),n=Float64Array.from(i,(l,h)=>Math.max(...[0,1,2].map(u=>Math.abs(t[3*h+u])))),s=Va(n,.999),r=e>0?Math.trunc(Math.min(zC,kC/Math.max(s,1e-9))/e):1,o=Math.floor(i.length/r);if(r<2||o<2*Lf)return{t:i,rates:t};let a=l=>Float64Array.from({length:o},(h,u)=>{let d=0;for(let f=u*r;f<(u+1)*r;f++)d+=l[f];return d/r}),c=[0,1,2].map(l=>a(cr(t,l)));return{t:a(i),rates:Float64Array.from({length:3*o},(l,h)=>c[h%3][Math.floor(h/3)])}}function VC(i,t){let e=o_(i,t,T_).filter(({first:s,last:r})=>i[r]-i[s]>=Nf),[n]=c_(i,t,e);return n.map(({first:s,last:r})=>({start:i[s],end:i[r],reason:"keeps an angular momentum"}))}function HC(i,t,e){let n=i.accelerationTimes;return A_(i,T_).map(({first:s,last:r})=>({start:n[s],end:n[r],reason:"the accelerometer feels no weight"})).filter(({start:s,end:r})=>r-s>=Nf).map(s=>WC(t,e,s))}function WC(i,t,e){let[n,s]=[kn(i,e.start),kn(i,e.end,!0)];if(s-n<Lf)return e;let r=a_(i.slice(n,s),t.slice(3*n,3*s));if(!r||r.change>Qh)return e;let[o,a]=[i[n+r.first],i[n+r.last]];return o-e.start>E_||e.end-a>E_||a-o<Nf?e:{...e,start:r.first===0?e.start:o,end:r.last===s-n-1?e.end:a}}var nu=3,Uf=.03,qC=-.1,XC=.003,[$C,YC]=[6,25],C_=1e-6,Of=.02,ZC=.04,JC=1e-6;function Ff(i,t,e,n=!1){let[s,r]=i.moments,o=e??{value:[0,0,0],spread:[Uf,Uf,Uf]},a={shape:[r-s,.5*(s+r-1)],axes:i.axes,bias:[...o.value],drag:n?[0,0,0]:null,starts:t.map(({rates:c,zero:l})=>jC(i.axes,He(c,l).map((h,u)=>h-o.value[u])))};for(let c of[100,500,2500,1/0])c<1/0&&!t.some(({elapsed:l})=>l.length>2*c)||(a=e3(a,t.map(l=>KC(l,c)),o));return r3(a,yo(a,t))}function KC({elapsed:i,rates:t,zero:e},n){if(!Number.isFinite(n))return{elapsed:i,rates:t,zero:e};let s=Math.max(e-n/2,0),r=Math.min(e+n/2,i.length);return{elapsed:i.slice(s,r),rates:t.slice(3*s,3*r),zero:e-s}}var jC=(i,t)=>[0,1,2].map(e=>i[0][e]*t[0]+i[1][e]*t[1]+i[2][e]*t[2]),P_=([i,t])=>[.5*(1-i)+t,.5*(1+i)+t,1];function yo({shape:i,axes:t,bias:e,drag:n,starts:s},r){let o=P_(i);return Math.min(...o)>XC?r.map(({elapsed:a,rates:c},l)=>{let h=n?null:new fi({moments:o,momentum:o.map((f,p)=>f*s[l][p])}),u=n&&QC(o,n,s[l],a),d=new Float64Array(c.length);return a.forEach((f,p)=>{let g=u?u[p]:h.angularVelocity(f);for(let m=0;m<3;m++)d[3*p+m]=c[3*p+m]-e[m]-xi(t[m],g)}),d}):null}function QC(i,t,e,n){let[s,r,o]=i,a=([u,d,f])=>{let p=Math.hypot(u,d,f);return[((r-o)*d*f-t[0]*p*u)/s,((o-s)*f*u-t[1]*p*d)/r,((s-r)*u*d-t[2]*p*f)/o]},c=new Array(n.length),l=kn(n,0),h=(u,d,f)=>{let[p,g]=[e,0];for(let m=u;m!==d;m+=f){let x=Math.max(1,Math.ceil(Math.hypot(...p)*Math.abs(n[m]-g)/ZC)),_=(n[m]-g)/x;for(let M=0;M<x;M++)p=t3(a,p,_);[c[m],g]=[p,n[m]]}};return h(l,n.length,1),h(l-1,-1,-1),c}function t3(i,t,e){let n=(c,l)=>t.map((h,u)=>h+l*e*c[u]),s=i(t),r=i(n(s,.5)),o=i(n(r,.5)),a=i(n(o,1));return t.map((c,l)=>c+e/6*(s[l]+2*r[l]+2*o[l]+a[l]))}function L_(i,t){let e=Rf(Tf(t.slice(2,5))),n=s=>[0,1,2].map(r=>e[r][s]);return{shape:[Math.min(Math.max(i.shape[0]+t[0],-1),1),Math.min(Math.max(i.shape[1]+t[1],qC),2)],axes:i.axes.map(s=>[0,1,2].map(r=>xi(s,n(r)))),bias:i.bias.map((s,r)=>s+t[5+r]),starts:i.starts.map((s,r)=>s.map((o,a)=>o+t[8+3*r+a])),drag:i.drag&&i.drag.map((s,r)=>s+t[8+3*i.starts.length+r])}}function e3(i,t,e){let n=i,s=yo(n,t);if(!s)return n;let r=ve(s.flatMap(o=>Array.from(o,Math.abs)))*1.5+1e-9;for(let o=0;o<$C;o++){n=i3(n,t,e,r);let a=r;if(r=n3(yo(n,t),N_(n)),Math.abs(r/a-1)<.02)break}return n}var N_=({starts:i,drag:t})=>8+3*i.length+(t?3:0);function n3(i,t){let e=i.flatMap(r=>Array.from({length:r.length/3},(o,a)=>xi(He(r,a),He(r,a)))),n=16*(ve(e)/2.366+1e-300),s=e.reduce((r,o)=>r+Math.min(o,n),0);return Math.max(Math.sqrt(s/Math.max(3*e.length-t,1)),1e-12)}function i3(i,t,e,n){let[s,r,o]=[i,yo(i,t),.001];for(let a=0;a<YC;a++){let{normal:c,right:l}=s3(s,t,r,e,n),h=I_(r,s,e,n),u=null;for(;!u&&o<1e12;){let d=Zh(c.map((m,x)=>m.map((_,M)=>M===x?_*(1+o)+1e-300:_)),l),f=d&&L_(s,d),p=f&&yo(f,t),g=p?I_(p,f,e,n):1/0;g<h?u={tried:f,residuals:p,next:g}:o*=10}if(!u||([s,r]=[u.tried,u.residuals],o=Math.max(o/10,1e-12),h-u.next<JC*h))break}return s}function I_(i,{bias:t,drag:e},n,s){let r=t.reduce((o,a,c)=>o+((a-n.value[c])/n.spread[c])**2,0);for(let o of e??[])r+=(o/Of)**2;for(let o of i)for(let a of o){let c=Math.abs(a/s);r+=c<=nu?c*c:nu*(2*c-nu)}return r}function s3(i,t,e,n,s){let r=N_(i),o=Array.from({length:r},(l,h)=>{let u=h<5||h>=8+3*t.length?C_:C_*Math.max(1,...i.starts.flat().map(Math.abs)),[d,f]=[u,-u].map(p=>yo(L_(i,Array.from({length:r},(g,m)=>m===h?p:0)),t));return!d||!f?e.map(p=>new Float64Array(p.length)):d.map((p,g)=>p.map((m,x)=>(f[g][x]-m)/(2*u)))}),a=Array.from({length:r},()=>new Array(r).fill(0)),c=new Array(r).fill(0);e.forEach((l,h)=>l.forEach((u,d)=>{let f=Math.min(1,nu*s/Math.max(Math.abs(u),1e-300))/s**2;for(let p=0;p<r;p++){let g=f*o[p][h][d];c[p]+=g*u;for(let m=0;m<=p;m++)a[p][m]+=g*o[m][h][d]}}));for(let l=0;l<r;l++)for(let h=0;h<l;h++)a[h][l]=a[l][h];for(let l=0;l<3;l++)a[5+l][5+l]+=n.spread[l]**-2,c[5+l]+=(n.value[l]-i.bias[l])/n.spread[l]**2;return(i.drag??[]).forEach((l,h)=>{let u=8+3*t.length+h;a[u][u]+=Of**-2,c[u]-=l/Of**2}),{normal:a,right:c}}function r3({shape:i,axes:t,bias:e,drag:n,starts:s},r){let o=P_(i),a=[0,1,2].sort((d,f)=>o[d]-o[f]),c=t.map(d=>a.map(f=>d[f])),l=Jh(c)<0?-1:1,h=o[a[2]],u=(r??[]).flatMap(d=>[...d]);return{moments:a.map(d=>o[d]/h),axes:c.map(([d,f,p])=>[d,f,l*p]),bias:e,drag:n&&a.map(d=>n[d]/h),starts:s.map(d=>a.map((f,p)=>(p===2?l:1)*d[f])),residuals:r??[],rms:Math.sqrt(u.reduce((d,f)=>d+f*f,0)/Math.max(u.length,1))}}var iu=3,o3=[125,245,250,500,1e3,2e3,4e3,143.4,286.7,573.4,1146.9,2293.8,4587.5].map(i=>i*Math.PI/180),a3=.0012,c3=.03,l3=1.5,h3=3,u3=3,D_=6,U_=1e-6,[d3,f3]=[20,32],p3=.8;function O_(i){let t=[];for(let a=0;a<i.length;a+=3)(a===0||[0,1,2].some(c=>i[a+c]!==i[a-3+c]))&&t.push(i[a],i[a+1],i[a+2]);let e=Float64Array.from(t);if(e.length/3<2*iu)return null;let n=Math.max(...[0,1,2].map(a=>F_(cr(e,a).map(Math.abs)))),s=m3(e).filter(({level:a})=>a>(1-c3)*n),r=a=>s.some(({axis:c,side:l})=>c!==a.axis||l!==a.side),o=s.filter(a=>B_(a.level)||a.runs>1||r(a)).map(({edge:a})=>a);return o.length?Math.min(...o):null}var F_=i=>Float64Array.from(i).sort().at(-iu),B_=i=>o3.some(t=>Math.abs(i/t-1)<a3);function m3(i){let t=[0,1,2].map(r=>cr(i,r)),e=t.map(r=>{let o=Ve(Array.from(new Set(r)).sort((a,c)=>a-c));return{step:o.length?Va(o,.05):0,noise:Xh([r],1)}}),n=e.map(({step:r})=>r).filter(r=>r>0),s=[];return t.forEach((r,o)=>{let a=r.reduce((h,u)=>Math.max(h,Math.abs(u)),0),c=Math.max(n.length?Math.min(...n):0,U_*a),{noise:l}=e[o];for(let h of[1,-1]){let u=r.map(f=>h*f),d=F_(u);for(let[f,p]of[[d,c],[d-.5*D_*l,D_*l]]){let g=p>0&&f>d3*p?g3(u,f,p):0;if(g){s.push({edge:p===c?d:f-p/2,level:f,axis:o,side:h,runs:g});break}}}}),s}function g3(i,t,e){let n=i.map(g=>(t-g)/e),s=Array.from(n,g=>Math.abs(g)<.5+1e-6),r=s.filter(Boolean).length,o=g=>n.reduce((m,x,_)=>m+ +(x<g&&!s[_]&&x>0),0),[a,c]=[o(4.5),o(16.5)];if(r<iu||a>(l3-1)*r)return 0;let l=is(Array.from(n,g=>g<16.5)).filter(([g,m])=>s.slice(g,m).filter(Boolean).length>=iu).length,h=i.filter((g,m)=>s[m]),[u,d]=h.reduce(([g,m],x)=>[Math.min(g,x),Math.max(m,x)],[1/0,-1/0]);if(B_(t)&&d-u<=U_*t)return Math.max(l,1);let f=c<h3*a&&c>u3*2*Math.max(l,1);return n.reduce((g,m)=>Math.max(g,m),-1/0)<f3||r>p3*i.length||f?0:l}var z_=8,x3=1.4,_3=2,y3=.3,v3=.2,M3=.9,S3=.003;function b3(i){let t=O_(i.rates),e=R_(i,t);if(!e.length)throw new de("no free flight was found in the log: no stretch of a quarter of a second keeps an angular momentum, or feels no weight. Throw it with a spin of a turn a second or more, and log from before the throw until after the catch.");return{limit:t,windows:e,throws:e.map(n=>w3(i,n,t))}}function w3({times:i,rates:t},{start:e,end:n},s){let r=Array.from(i.keys()).filter(c=>i[c]>=e&&i[c]<=n&&(s===null||He(t,c).every(l=>Math.abs(l)<s*Df)));if(r.length<z_)throw new de(`a throw must have ${z_} samples that are not at the gyro's limit; got ${r.length}. Throw more slowly.`);let o=Math.floor(r.length/2),a=i[r[o]];return{times:Float64Array.from(r,c=>i[c]),elapsed:Float64Array.from(r,c=>i[c]-a),rates:Float64Array.from(r.flatMap(c=>He(t,c))),zero:o,epoch:a}}function A3(i,t){let e=Pf(i).map(([a,c])=>({start:i.times[a],end:i.times[c],mean:ss(i.rates,a,c+1)})).filter(a=>!t.some(({start:c,end:l})=>a.start<l&&a.end>c)),n=e.reduce((a,{start:c,end:l})=>a+l-c,0);if(!(n>0))return null;let s=a=>[0,1,2].map(c=>e.reduce((l,h)=>l+(h.end-h.start)/n*a(h,c),0)),r=s((a,c)=>a.mean[c]),o=s((a,c)=>(a.mean[c]-r[c])**2);return{value:r,spread:o.map(a=>Math.hypot(S3,Math.sqrt(a)))}}function G_(i){let{limit:t,windows:e,throws:n}=b3(i),s=t_(n);if(s.degenerate)throw new de(s.degenerate);let r=A3(i,e),o=Ff(s,n,r),a=k_(o,s.noise)&&Ff(s,n,r,!0),c=a&&a.rms<M3*o.rms?a:o,l=n.flatMap(({rates:u})=>Array.from(u,d=>d*d)),h=Math.sqrt(l.reduce((u,d)=>u+d,0)/l.length);if(!(c.rms<v3*h))throw new de(`no free motion of a rigid body explains the log: the residuals, ${c.rms.toPrecision(2)} rad/s, are not small beside the rates, ${h.toPrecision(2)} rad/s. Check columns and units, or log a free flight.`);return{throws:n,windows:e,limit:t,start:s,rest:r,fit:c,misfit:k_(c,s.noise)}}function k_({residuals:i,rms:t,drag:e},n){let s=i.flatMap(d=>Array.from(d,Math.abs)),[r,o]=[ve(s)/.6745,s.reduce((d,f)=>d+f*f,0)],c=i.reduce((d,f)=>d+f.slice(3).reduce((p,g,m)=>p+g*f[m],0),0)/Math.max(o,1e-300),l=d=>d<100?d.toPrecision(2):d.toFixed(0),h=null;return r>x3*n?h=`${l(r/n)} times the noise of a sample`:c>y3?h=`alike from sample to sample (correlation ${c.toFixed(2)})`:t>_3*n&&(h=`larger than the noise at a few samples, up to ${Math.max(...s).toPrecision(2)} rad/s`),h?`The log is not ${e?"the motion of a rigid body with drag":"a free rigid body's motion"} within its noise: the residuals (${t.toPrecision(2)} rad/s rms, noise ${n.toPrecision(2)} rad/s) are ${h}. A gyro's gains, a clock that jitters or a catch within the window do that; polhode fit fits gains too, and gives errors.`:null}var V_=64e6,E3="phyphox, Sensor Logger, AndroSensor, Betaflight, or any table with a time and three angular velocities",Sn=(i,t={},...e)=>{let n=Object.assign(document.createElement(i),t);return n.append(...e),n},su=class{constructor(t,e){this.open=e,this.input=Sn("input",{type:"file",accept:".csv,.txt,.tsv,text/csv,text/plain",hidden:!0}),this.input.addEventListener("change",()=>{this.input.files.length&&this.take(this.input.files[0]),this.input.value=""});let n=Sn("button",{type:"button",className:"wide",textContent:"Open a gyro log\u2026"});n.addEventListener("click",()=>this.input.click()),this.said=Sn("p",{id:"log-said"}),this.said.setAttribute("role","status"),this.form=Sn("form",{id:"log-columns",hidden:!0}),this.form.addEventListener("submit",r=>{r.preventDefault(),this.fit()});let s=Sn("span",{className:"hint",textContent:`or drop it on this page: ${E3}. It stays on this computer.`});this.root=Sn("section",{id:"log"},Sn("p",{},n," ",s),this.input,this.said,this.form),this.root.setAttribute("aria-label","A log of your own"),t.after(this.root),this.listen()}listen(){let t=n=>[...n.dataTransfer?.types??[]].includes("Files"),e=n=>document.documentElement.classList.toggle("dropping",n);window.addEventListener("dragover",n=>{t(n)&&(n.preventDefault(),e(!0))}),window.addEventListener("dragleave",n=>!n.relatedTarget&&e(!1)),window.addEventListener("drop",n=>{t(n)&&(n.preventDefault(),e(!1),n.dataTransfer.files.length&&this.take(n.dataTransfer.files[0]))})}async take(t){this.form.hidden=!0,this.name=t.name;try{if(t.size>V_)throw new de(`it has ${Math.round(t.size/1e6)} MB, and at most ${V_/1e6} MB are read. Cut the log to the throw.`);let e=await t.text();if(e.startsWith("PK"))throw new de("it is a zip archive. Unpack it, and choose the table inside, like Gyroscope.csv or Raw Data.csv.");this.table=Xx(e),this.mapping=$x(this.table),this.ask();let{time:n,timeUnit:s,gyro:r,rateUnit:o}=this.mapping;n!==null&&s&&r&&o?await this.fit():this.say(`${this.name}: no app that is known writes such a header. Choose what the columns are, and the units that the file does not say.`)}catch(e){this.refuse(e)}}ask(){let{form:t,dialect:e}=this.table,{time:n,timeUnit:s,gyro:r,rateUnit:o}=this.mapping,a=Array.from({length:t.width},(u,d)=>[d,t.names[d]||`column ${d+1}`]),c=u=>Object.keys(u).map(d=>[d,d]);this.fields={time:lr("time",a,n),timeUnit:lr("unit of the time",c(es),s),x:lr("angular velocity x",a,r?.[0]),y:lr("angular velocity y",a,r?.[1]),z:lr("angular velocity z",a,r?.[2]),rateUnit:lr("its unit",c(ns),o)};let l=Sn("summary",{textContent:"Columns and units"}),h=Sn("details",{open:!e},l,...Object.values(this.fields),Sn("button",{type:"submit",className:"wide",textContent:"Read the log"}));this.form.replaceChildren(h),this.form.hidden=!1}async fit(){let t=Object.fromEntries(Object.entries(this.fields).map(([s,r])=>[s,r.querySelector("select").value])),e=s=>t[s]===""?null:Number(t[s]),n={time:e("time"),timeUnit:t.timeUnit,gyro:["x","y","z"].map(e),rateUnit:t.rateUnit};this.say(`${this.name}: fitting\u2026`),await new Promise(s=>setTimeout(s,30));try{this.log=Yx(this.table,n),this.found=G_(this.log),this.show(T3(this.found.windows))}catch(s){this.refuse(s)}}show(t){let e=n_(this.found,this.log,this.name,t);this.open(e);for(let o of document.querySelectorAll("#presets button"))o.setAttribute("aria-pressed","false");document.getElementById("story").replaceChildren(...e.story.map(o=>Sn("li",{textContent:o}))),this.say("");let{windows:n}=this.found;if(n.length<2)return;let s=n.map(({start:o,end:a},c)=>[c,`${o.toPrecision(4)} s to ${a.toPrecision(4)} s`]),r=lr("which throw",s,t);r.querySelector("select").addEventListener("change",o=>this.show(Number(o.target.value))),this.said.replaceChildren(r)}refuse(t){if(!(t instanceof de||t instanceof RangeError))throw t;this.say(`${this.name}: ${t.message}`,!0)}say(t,e=!1){this.said.textContent=t,this.said.classList.toggle("wrong",e)}};function T3(i){let t=0;return i.forEach(({start:e,end:n},s)=>{n-e>i[t].end-i[t].start&&(t=s)}),t}function lr(i,t,e){let n=Sn("select",{required:!0}),s=e!=null;return s||n.append(Sn("option",{value:"",textContent:"choose\u2026"})),n.append(...t.map(([r,o])=>Sn("option",{value:String(r),textContent:o,selected:s&&r===e}))),Sn("label",{},`${i} `,n)}var qa=Math.SQRT2,[R3,C3]=[.5,8],I3=1.5,H_=[.5,1.6],Bf=20,[W_,P3]=[8,240],[L3,N3]=[1,3600],q_=20,ru=class{constructor(t,{seek:e,beyond:n,told:s}){this.root=t,this.seek=e,this.beyond=n,this.told=s,this.position=0,this.playing=!1,this.looping=!1,this.goesOn=!1,this.slider=t.querySelector("#seek"),this.play=t.querySelector("#play"),this.loop=t.querySelector("#loop"),this.speed=t.querySelector("#speed"),this.shown=t.querySelector("#now");let r=(o,a)=>t.querySelector(o).addEventListener("click",a);r("#play",()=>this.toggle()),r("#back",()=>this.step(-1)),r("#forth",()=>this.step(1)),r("#loop",()=>this.repeat()),r("#slower",()=>this.scale(1/qa)),r("#faster",()=>this.scale(qa)),this.slider.addEventListener("input",()=>{this.pause(),this.go(Number(this.slider.value))}),document.addEventListener("keydown",o=>this.key(o))}take(t,e,n=null,s=null){this.motion=t,this.slider.max=String(t.count-1),this.single=t.count<2||!(t.span>0);for(let r of this.root.querySelectorAll("button, input"))r.disabled=this.single;this.loop.hidden=!!t.endless,e&&(this.rate=D3(t,s),this.pause()),n===null?this.go(0):this.goTo(n)}key(t){if(this.single||t.ctrlKey||t.metaKey||t.altKey||t.target!==this.slider&&t.target.closest?.("input, select, textarea"))return;let e=t.target===this.slider,n=t.target.closest?.("button, a, summary");if(t.target.closest?.("canvas")&&t.key.startsWith("Arrow"))return;let r={" ":()=>!n&&this.toggle(),k:()=>this.toggle(),l:()=>this.repeat(),ArrowLeft:()=>!e&&this.step(t.shiftKey?-q_:-1),ArrowRight:()=>!e&&this.step(t.shiftKey?q_:1),Home:()=>!e&&this.home(),End:()=>!e&&this.to(this.motion.count-1),"+":()=>this.scale(qa),"=":()=>this.scale(qa),"-":()=>this.scale(1/qa)}[t.key];r&&r()!==!1&&t.preventDefault()}toggle(){if(this.playing)return this.pause();this.position>=this.motion.count-1&&!this.motion.endless&&!this.goesOn&&this.go(0),this.playing=!0,this.begun=null,this.say(),requestAnimationFrame(t=>this.tick(t))}pause(){this.playing=!1,this.say()}repeat(){this.looping=!this.looping,this.say()}home(){if(!this.motion.endless)return this.to(0);this.pause(),this.beyond(this.motion.solver.epoch)}tick(t){if(!this.playing)return;let e=this.begun===null?0:Math.min((t-this.begun)/1e3,.25);this.begun=t,this.advance(this.time+e*this.rate),this.playing&&requestAnimationFrame(n=>this.tick(n))}advance(t){let e=this.motion.times[this.motion.count-1];if(t<=e)return this.goTo(t);if(this.motion.endless||this.goesOn&&!this.looping)return this.beyond(t);if(this.looping)return this.goTo(this.motion.times[0]+(t-e)%this.motion.span);this.goTo(e),this.pause()}step(t){this.to(Math.round(this.position)+t)}to(t){this.pause(),this.go(t)}go(t){this.position=Math.min(this.motion.count-1,Math.max(0,t)),this.time=this.motion.at(this.position).time,this.refresh()}goTo(t){this.time=t,this.position=this.motion.positionOf(t),this.refresh()}refresh(){this.slider.value=String(Math.round(this.position)),this.slider.style.setProperty("--part",`${100*this.position/Math.max(1,this.motion.count-1)}%`);let t=Mn(this.time,Math.max(this.motion.span,Math.abs(this.time)));this.slider.setAttribute("aria-valuetext",t),this.shown.textContent=t,this.seek(this.position,this.time)}scale(t){let{span:e}=this.motion;this.rate=Math.min(e/L3,Math.max(e/N3,this.rate*t)),this.say()}quicken(t){t!==null&&t>Bf*this.rate&&(this.rate=X_(t/Bf)),this.say()}say(){this.play.setAttribute("aria-label",this.playing?"Pause":"Play"),this.play.dataset.playing=String(this.playing),this.loop.setAttribute("aria-pressed",String(this.looping)),this.rate&&(this.speed.textContent=Math.abs(this.rate-1)<.05?"real time":`\xD7${zt(this.rate,2)}`),this.told()}};function D3(i,t){if(!(i.span>0))return 1;let e=i.hasUp?C3:R3,n=i.fastest?2*Math.PI*e/i.fastest:i.span/40,s=i.solver?.nutationPeriod,r=s&&Number.isFinite(s)?s/I3:1/0,o=Math.min(i.span/W_,Math.max(i.span/P3,Math.min(n,r))),a=Math.min(i.span/W_,(t??0)/Bf);if(o>H_[0]&&o<H_[1]&&a<=1)return 1;if(a>o)return X_(a);let c=10**Math.floor(Math.log10(o));return([5,2,1].find(h=>h*c<=o*1.0001)??1)*c}function X_(i){let t=10**Math.floor(Math.log10(i));return[1,2,5,10].find(e=>e*t>=.9999*i)*t}var Hf={};as(Hf,{BufferGeometry:()=>_e,Color:()=>Ot,ConeGeometry:()=>ms,CylinderGeometry:()=>oi,DataTexture:()=>ri,Float32BufferAttribute:()=>ee,Group:()=>he,InstancedMesh:()=>Go,LinearFilter:()=>Be,Matrix4:()=>Qt,Mesh:()=>Yt,MeshBasicMaterial:()=>ln,MeshLambertMaterial:()=>gn,PlaneGeometry:()=>Ks,Quaternion:()=>ae,SphereGeometry:()=>Dn,Vector3:()=>C,circle:()=>Li,contactSound:()=>Z_,dot:()=>Bs,drawUpTo:()=>ts,endsLegend:()=>Gf,floor:()=>fo,globe:()=>uo,line:()=>Je,mapGlobe:()=>Y_,mappedGlobe:()=>kf,newPanel:()=>Bn,pairThrough:()=>Ea,path:()=>Qi,pieces:()=>ho,polhodeThrough:()=>ir,specks:()=>rr,unpacked:()=>ue});var zf=[[33,102,172],[178,24,43]],$_=247,U3=6;function O3(){let i=new Uint8Array(1024);for(let t=0;t<256;t++){let e=t<127.5?0:1,n=Math.abs(t-127.5)/127.5;for(let s=0;s<3;s++)i[4*t+s]=Math.round($_+(zf[e][s]-$_)*n**.8);i[4*t+3]=255}return i}function F3(i,t,e){let n=t*e,s=(a,c,l)=>Array.from({length:a},(h,u)=>{let d=(u+.5)/e-.5,f=Math.floor(d),p=g=>l?(g+c)%c:Math.min(Math.max(g,0),c-1);return[p(f),p(f+1),d-f]}),r=s(n,t,!0),o=s(i*e,i,!1);return(a,c,l)=>{o.forEach(([h,u,d],f)=>{let p=c+h*t,g=c+u*t;for(let m=0;m<n;m++){let[x,_,M]=r[m],v=a[p+x]+M*(a[p+_]-a[p+x]),b=a[g+x]+M*(a[g+_]-a[g+x]);l[f*n+m]=v+d*(b-v)}})}}function kf(i,t){let e=i*t,n=O3(),s=new Uint8Array(4*e),r=new ri(s,t,i);r.magFilter=r.minFilter=Be,r.colorSpace="srgb";let o=new Dn(1,96,64);return o.rotateX(Math.PI/2),o.rotateZ(Math.PI),{mesh:new Yt(o,new ln({map:r})),paint:(l,h=null)=>{for(let u=0;u<e;u++){let d=Math.round(l[u]);if(s.set(n.subarray(4*d,4*d+4),4*u),h?.(u))for(let f=0;f<3;f++)s[4*u+f]*=.35}r.needsUpdate=!0},pixels:s}}var Gf=i=>[{color:`rgb(${zf[1].join(", ")})`,text:i[1]},{color:`rgb(${zf[0].join(", ")})`,text:i[0]}];function Y_(i,t,{title:e,words:n,legend:s}){let r=i.lines?U3:1,[o,a]=[i.rows*r,i.columns*r],c=ue(i.levels),l=i.lines?ue(i.lines):null,h=ue(i.frames),[u,d]=[i.rows*i.columns,o*a],f=F3(i.rows,i.columns,r),{mesh:p,paint:g,pixels:m}=kf(o,a),[x,_,M]=[new Float32Array(d),new Float32Array(d),new Uint8Array(d)],v=Bn(t,{title:e,words:n,radius:1.3});v.scene.add(p);for(let S of[-.5,0,.5])v.scene.add(Li(1.002*Math.sqrt(1-S*S),1.002*S,t.family));v.legend=Gf(s);let b=(S,I,T,L)=>{if(f(S,u*I,x),L!==0){f(S,u*T,_);for(let N=0;N<d;N++)x[N]+=L*(_[N]-x[N])}},w=S=>{let I=S%a===a-1?S+1-a:S+1,T=S+a<d?S+a:S;return M[S]!==M[I]||M[S]!==M[T]},y=-1;return v.update=S=>{if(S.position===y)return;y=S.position;let I=0;for(;I<h.length-2&&h[I+1]<=S.position;)I++;let T=Math.min(I+1,h.length-1),L=T>I?Math.min(1,(S.position-h[I])/(h[T]-h[I])):0;if(l){b(l,I,T,L);for(let N=0;N<d;N++)M[N]=Math.floor(x[N]/256*i.bands)}b(c,I,T,L),g(x,l&&w)},v.probe=()=>({shown:y,pixels:[...m.subarray(0,16)]}),v}var Vf=class{constructor(){this.on=!1,this.context=null,this.rate=0}toggle(){this.on=!this.on,this.on&&!this.context&&this.make(),this.on?this.context.resume():this.quiet()}make(){this.context=new AudioContext;let t=Float32Array.from({length:49},(e,n)=>n?1:0);this.oscillator=this.context.createOscillator(),this.oscillator.setPeriodicWave(this.context.createPeriodicWave(t,new Float32Array(49))),this.gain=this.context.createGain(),this.gain.gain.value=0,this.oscillator.connect(this.gain).connect(this.context.destination),this.oscillator.start()}follow(t){if(this.rate=t,!this.on)return;let{currentTime:e}=this.context;this.oscillator.frequency.setTargetAtTime(Math.min(t,2e3),e,.03),this.gain.gain.setTargetAtTime(t>0?.25:0,e,.03),clearTimeout(this.waiting),this.waiting=setTimeout(()=>this.quiet(),150)}quiet(){this.gain?.gain.setTargetAtTime(0,this.context.currentTime,.03)}probe(){return{on:this.on,rate:this.rate,frequency:this.oscillator?.frequency.value??null,gain:this.gain?.gain.value??null}}},Z_=new Vf;var B3={axis:Q0,body:dx,poinsot:fx,sphere:_x,...globalThis.polhodePanels},Rn=i=>document.getElementById(i),Wf=class{constructor(t){this.view=new Ql(()=>this.draw()),this.stage=new Fh(this.view),this.panels=[],this.canvases=[],this.waiting=null;let e=window.matchMedia("(prefers-color-scheme: dark)");this.theme=e.matches?Gs.dark:Gs.light,e.addEventListener("change",s=>this.dress(s.matches?Gs.dark:Gs.light)),Rn("theme").addEventListener("click",()=>this.dress(this.theme===Gs.dark?Gs.light:Gs.dark)),Rn("reset").addEventListener("click",()=>this.instrument?.reset());for(let s of document.querySelectorAll("button"))s.addEventListener("pointerup",()=>s.blur());new ResizeObserver(()=>this.sizes()!==this.shapes&&this.draw()).observe(Rn("panels")),this.room=new Ph(["summary","refused","facts","notes","readouts","plots"].map(Rn)),this.plots=new zh(Rn("plots"),s=>{this.timebar.pause(),this.goTo(s)}),this.timebar=new ru(Rn("timebar"),{seek:(s,r)=>this.show(s,r),beyond:s=>this.goTo(s),told:()=>this.told()}),this.address=new Ya(()=>this.seen,s=>this.open(this.playground?.find(s.preset)??t,s)),this.views=new Ih(Rn("panels"),()=>this.looked()),this.sharing=new Wh(this),this.playground=t.presets?new Gh(t.presets,s=>this.open(s),s=>this.tell(s)):null,t.presets&&new su(Rn("playground"),s=>this.open(s));let{tables:n}=this.address;this.open(this.playground?.find(n.preset)??t,n)}open(t,e=null){let n=this.timebar.playing;this.data=t,Cd(t),this.room.release(),this.view.letGo(),this.view.elevation=t.panels[0].elevation??this.view.elevation,this.view.azimuth=t.panels[0].azimuth??this.view.azimuth,this.instrument=null,this.shaped=!1,Rn("instrument").hidden=!t.model,t.model&&(this.instrument=new Ch(t.model,s=>this.reset(s)),this.epoch=this.instrument.setting.epoch),this.motion=t.model&&!t.attitude?this.instrument.motion(z3(t),t.space):new bh(t),Rn("panels").replaceChildren(),this.canvases=t.panels.map(s=>rg(s,this.view)),this.canvases.forEach((s,r)=>this.listen(s,r)),this.views.take(t.panels.map(({type:s})=>s)),this.readouts=new Vh(Rn("readouts"),this.motion,t),this.now=this.motion.at(0),this.build(),this.timebar.goesOn=!!this.instrument,this.timebar.take(this.motion,!0,null,this.instrument?.event),this.sharing.take(),e&&this.restore(e),n&&this.timebar.toggle(),this.address.write()}restore({t=null,preset:e,view:n=null,...s}){Object.keys(s).length&&this.instrument?.set(s),n!==null&&this.views.enlarge(String(n)),typeof t=="number"&&this.goTo(t)}get seen(){let{key:t}=this.data,{named:e}=this.views,n=!this.timebar.playing&&this.now.time!==this.begins;return{...t?{preset:t}:{},...this.instrument?.tables,...e?{view:e}:{},...n?{t:this.now.time}:{}}}get begins(){return this.instrument?.setting.epoch??this.motion.times[0]}tell({set:t,view:e}){return e?this.views.enlarge(e):(t&&this.instrument?.set(t)?this.timebar.quicken(this.instrument.event):t||this.instrument?.reset(),this.goTo(this.begins),!J_()&&!this.timebar.playing&&this.timebar.toggle(),this.address.write())}looked(){this.view.letGo(),this.draw(),this.address.write()}told(){this.sharing&&this.motion&&this.sharing.suggest(),this.instrument!==void 0&&this.address.changed()}reset(t){this.room.keep();let{epoch:e}=this.instrument.setting,n=e===this.epoch?this.now.time:e;this.epoch=e,this.shaped=t,Rn("summary").textContent=this.instrument.isAsGiven?this.data.summary:"Set on this page.";let s=this.instrument.motion();this.motion=s.around(n),this.readouts.take(this.motion,this.data,!0),this.build(),this.timebar.take(this.motion,!1,n),this.sharing.suggest(),this.room.keep(),this.address.changed()}build(){for(let e of this.panels)K0(e.scene);document.documentElement.dataset.theme=this.theme.name,this.panels=this.data.panels.map(e=>{let n=this.changedPanel(e);return Object.assign(B3[e.type](this.motion,n,this.theme,Hf),{type:e.type})}),this.panels.forEach((e,n)=>og(this.canvases[n],e,this.data,()=>this.draw()));let t=this.instrument&&!this.instrument.isAsGiven;this.plots.take(this.motion,t?{...this.data,scatters:[],plots:[]}:this.data,this.theme),this.draw()}changedPanel(t){return this.shaped&&t.type==="body"?{...t,surface:null,ellipsoid:null,changed:!0}:this.instrument&&!this.instrument.isAsGiven&&t.type==="sphere"?{...t,changed:!0,equilibria:null}:t}dress(t){this.theme=t,this.build()}show(t,e){this.now=this.motion.endless?{position:t,...this.motion.solvedAt(e)}:this.motion.at(t),this.timebar.playing||this.address.changed(),this.draw()}goTo(t){if(!Number.isFinite(t))return;let{times:e,count:n}=this.motion,s=t<e[0]||t>e[n-1],r=this.motion.endless?this.motion.around(t):s&&this.instrument?this.instrument.motion().around(t):this.motion;r!==this.motion?(this.motion=r,this.build(),this.timebar.take(r,!1,t)):this.timebar.goTo(t)}draw(){this.waiting??=requestAnimationFrame(()=>this.drawNow())}drawNow(){cancelAnimationFrame(this.waiting),this.waiting=null,this.shapes=this.sizes();for(let t of this.panels)t.update(this.now);this.stage.draw(this.panels,this.canvases,this.theme),this.plots.draw(this.now),this.readouts.show(this.now),this.sharing.frame(),window.polhode.drawn+=1,window.polhode.firstPicture??=performance.now()}drawn(){return this.waiting&&this.drawNow(),this}sizes(){return this.canvases.map(t=>`${t.clientWidth} ${t.clientHeight}`).join()}listen(t,e){let n=s=>{let r=t.getBoundingClientRect();return[(s.clientX-r.left)/r.width*2-1,1-(s.clientY-r.top)/r.height*2]};t.addEventListener("pointerdown",s=>{let r=this.panels[e];if(s.button!==0||!r.grasp||!this.instrument?.kind.dragged||!r.grasp(n(s),t.clientWidth))return;s.stopImmediatePropagation(),this.timebar.pause(),t.setPointerCapture(s.pointerId);let o=c=>{let l=this.panels[e].under(n(c));l&&(this.now={...this.now,time:this.instrument.setting.epoch},this.instrument.point(l))},a=()=>{t.removeEventListener("pointermove",o);for(let c of["pointerup","pointercancel"])t.removeEventListener(c,a)};t.addEventListener("pointermove",o);for(let c of["pointerup","pointercancel"])t.addEventListener(c,a)},{capture:!0})}shot(t=null){t||this.drawn();let e=this.canvases[this.views.large],n=t??document.createElement("canvas");t||([n.width,n.height]=[e.width,e.height].map(c=>c-c%2));let s=n.getContext("2d");s.fillStyle=this.theme.ground,s.fillRect(0,0,n.width,n.height);let r=Math.min(n.width/e.width,n.height/e.height),[o,a]=[e.width*r,e.height*r];return s.drawImage(e,.5*(n.width-o),.5*(n.height-a),o,a),n}},J_=()=>window.matchMedia("(prefers-reduced-motion: reduce)").matches,z3=i=>ue(i.times);function k3(i){return{drawn:0,firstPicture:null,get count(){return i.motion.count},get times(){return i.motion.times},view:i.view,enlarge:t=>i.views.enlarge(t),shown:()=>({theme:i.theme.name,position:i.now.position,time:i.now.time}),seek(t){i.timebar.to(t),i.drawNow()},goTo(t){i.goTo(t),i.drawn()},get playing(){return i.timebar.playing},set:t=>i.instrument?.set(t)??!1,settings:()=>i.instrument?.kind.asSpec(i.instrument.setting)??null,state(t){let e=i.motion.endless?i.motion:i.instrument?.motion([t]),n=e?e.solvedAt(t):i.motion.at(i.motion.positionOf(t)),{w:s,x:r,y:o,z:a}=n.attitude??{};return{attitude:n.attitude?[s,r,o,a]:null,momentum:n.momentum?.toArray()??null}},spec:()=>i.instrument?.toml(i.motion.span)??null,plots:()=>i.drawn().plots.probe(),names:()=>i.drawn().panels.map(t=>t.boxes??[]),measure(t,...e){i.drawn();let n=i.panels.find(s=>s.type===t)?.probe();return n&&e.length?Object.fromEntries(e.map(s=>[s,n[s]])):n}}}try{let i=JSON.parse(Rn("motion").textContent);window.polhode={drawn:0,firstPicture:null},Cd(i.presets?i.presets[0]:i);let t=new Wf(i);window.polhode=k3(t),window.seek=e=>window.polhode.seek(e),t.draw(),!J_()&&t.motion.count>1&&t.motion.span>0&&requestAnimationFrame(()=>t.timebar.toggle())}catch(i){let t=Rn("failure");throw t.hidden=!1,t.textContent=`The pictures cannot be drawn (${i.message}). They need a browser with WebGL 2.`,i}})();
